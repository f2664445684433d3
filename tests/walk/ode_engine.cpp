#include "tests/walk/engine.h"

#if FORESIGHT_ODE

#define dDOUBLE
#include <ode/ode.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <vector>

#include "tests/walk/mujoco_model.h"

namespace robot::nao::walk {
namespace {

constexpr double kCoupling = 1000;      // [N m/rad] of the two hip joints that share a motor
constexpr double kCouplingDamping = 2;  // [N m s/rad]
constexpr double kDryFriction = 0.05;   // [N m] of a joint
constexpr double kDrySpeed = 0.05;      // [rad/s] from which on it has its full strength
constexpr double kCarried = 1.3;        // [kg] by one of four contacts
constexpr double kImpedance = 12;  // a resting contact is so much stiffer than its time constant says, as in MuJoCo
constexpr int kMostContacts = 8;   // of two shapes
constexpr std::size_t kLeftHip = 0, kRightHip = kLegJoints;

using Vector = std::array<double, 3>;
using Matrix = std::array<double, 9>;  // by rows

Vector vector_at(const mjtNum* values) { return {values[0], values[1], values[2]}; }
Matrix matrix_at(const mjtNum* values) {
  Matrix matrix{};
  std::copy_n(values, 9, matrix.begin());
  return matrix;
}
Vector operator+(const Vector& a, const Vector& b) { return {a[0] + b[0], a[1] + b[1], a[2] + b[2]}; }
Vector operator-(const Vector& a, const Vector& b) { return {a[0] - b[0], a[1] - b[1], a[2] - b[2]}; }
Vector operator*(const Matrix& m, const Vector& v) {
  return {m[0] * v[0] + m[1] * v[1] + m[2] * v[2], m[3] * v[0] + m[4] * v[1] + m[5] * v[2],
          m[6] * v[0] + m[7] * v[1] + m[8] * v[2]};
}
Matrix transposed(const Matrix& m) { return {m[0], m[3], m[6], m[1], m[4], m[7], m[2], m[5], m[8]}; }
Matrix operator*(const Matrix& a, const Matrix& b) {
  Matrix product{};
  for (std::size_t row = 0; row < 3; ++row)
    for (std::size_t column = 0; column < 3; ++column)
      for (std::size_t k = 0; k < 3; ++k) product[3 * row + column] += a[3 * row + k] * b[3 * k + column];
  return product;
}

struct WorldDeleter {
  void operator()(dWorldID world) const { dWorldDestroy(world); }
};
struct SpaceDeleter {
  void operator()(dSpaceID space) const { dSpaceDestroy(space); }
};
struct GroupDeleter {
  void operator()(dJointGroupID group) const { dJointGroupDestroy(group); }
};

/// MuJoCo only reads the model and places the links at the beginning.
class OdeEngine final : public Engine {
 public:
  explicit OdeEngine(const Scene& scene) : model_(load_model(scene)), data_(mj_makeData(model_.get())) {
    static const bool ready = dInitODE2(0) != 0;
    (void)ready;
    torso_ = mj_name2id(model_.get(), mjOBJ_BODY, "torso");
    for (int sensor = 0; sensor < model_->nsensor; ++sensor)
      if (model_->sensor_type[sensor] == mjSENS_TOUCH) sites_.push_back(model_->sensor_objid[sensor]);
  }

  void reset(const DrawnRobot& robot, Dice&, const PerMotor& angles, double torso_height) override {
    robot_ = robot;
    contacts_.reset();  // before the world of its joints
    space_.reset();
    world_.reset(dWorldCreate());
    space_.reset(dSimpleSpaceCreate(nullptr));
    contacts_.reset(dJointGroupCreate(0));
    dWorldSetGravity(world_.get(), 0, 0, -kGravity);
    mj_resetData(model_.get(), data_.get());
    mj_kinematics(model_.get(), data_.get());
    build_links();
    build_joints();
    build_shapes();

    for (std::size_t motor = 0; motor < motors(); ++motor)
      data_->qpos[model_->jnt_qposadr[model_->actuator_trnid[2 * motor]]] = angles[motor];
    turn(torso_height, {1, 0, 0, 0});
    torques_ = {};
    loads_ = {};
    push_ = {};
    time_ = 0;
  }

  void turn(double torso_height, const std::array<double, 4>& rotation) override {
    data_->qpos[2] = torso_height;
    std::copy(rotation.begin(), rotation.end(), data_->qpos + 3);
    mj_kinematics(model_.get(), data_.get());
    for (const Link& link : links_) {
      const Matrix axes = axes_of(link.body);
      const Vector at = origin_of(link.body) + axes * link.centre;
      dBodySetPosition(link.id, at[0], at[1], at[2]);
      const dMatrix3 turned = {axes[0], axes[1], axes[2], 0,       axes[3], axes[4],
                               axes[5], 0,       axes[6], axes[7], axes[8], 0};
      dBodySetRotation(link.id, turned);
    }
  }

  void step() override {
    for (std::size_t motor = 0; motor < motors(); ++motor) servo(motor);
    const Link& torso = link_of(torso_);
    const Vector centre = vector_at(model_->body_ipos + 3 * torso_) - torso.centre;
    dBodyAddForceAtRelPos(torso.id, push_[0], push_[1], 0, centre[0], centre[1], centre[2]);
    touches_.clear();
    dSpaceCollide(space_.get(), this,
                  [](void* engine, dGeomID one, dGeomID other) { static_cast<OdeEngine*>(engine)->touch(one, other); });
    feedback_.resize(touches_.size());
    for (std::size_t i = 0; i < touches_.size(); ++i) dJointSetFeedback(touches_[i].joint, &feedback_[i]);
    dWorldStep(world_.get(), kStep);
    weigh();
    dJointGroupEmpty(contacts_.get());
    time_ += kStep;
  }

  double now() const override { return time_; }
  std::size_t motors() const override { return kLegMotors; }
  JointState joint(std::size_t motor) const override {
    return {dJointGetHingeAngle(hinges_[motor]), dJointGetHingeAngleRate(hinges_[motor])};
  }
  void drive(std::size_t motor, double torque) override { torques_[motor] = torque; }
  void push(double x, double y) override { push_ = {x, y, 0}; }

  std::array<double, 3> position() const override {
    const Link& torso = link_of(torso_);
    return vector_at(dBodyGetPosition(torso.id)) - rotation() * torso.centre;
  }
  std::array<double, 9> rotation() const override {
    const dReal* const m = dBodyGetRotation(link_of(torso_).id);  // rows of four
    return {m[0], m[1], m[2], m[4], m[5], m[6], m[8], m[9], m[10]};
  }
  std::array<double, 3> rate() const override {
    return transposed(rotation()) * vector_at(dBodyGetAngularVel(link_of(torso_).id));
  }
  std::array<double, 8> loads() const override { return loads_; }

  bool has_ball() const override { return false; }
  RollingBall ball() const override { return {}; }
  void place(const RollingBall&) override {}

 private:
  /// A body that a joint moves, with all that is fixed to it.
  struct Link {
    int body;       // of the model
    Vector centre;  // of its mass, from its origin
    dBodyID id;
  };
  struct Touch {
    dJointID joint;
    Vector at, normal;
    int foot;  // body of the model
  };

  Vector origin_of(int body) const { return vector_at(data_->xpos + 3 * body); }
  Matrix axes_of(int body) const { return matrix_at(data_->xmat + 9 * body); }

  /// Returns the body whose joint moves this one.
  int mover_of(int body) const {
    while (model_->body_jntnum[body] == 0) body = model_->body_parentid[body];
    return body;
  }
  const Link& link_of(int body) const {
    return *std::ranges::find_if(links_, [&](const Link& link) { return link.body == mover_of(body); });
  }

  void build_links() {
    links_.clear();
    for (int body = 1; body < model_->nbody; ++body) {
      if (mover_of(body) != body) continue;
      const Matrix to_link = transposed(axes_of(body));
      double mass = 0;
      Vector moment{};
      Matrix inertia{};  // about the origin
      for (int part = body; part < model_->nbody; ++part) {
        if (mover_of(part) != body) continue;
        const double m = model_->body_mass[part];
        const Vector at = to_link * (vector_at(data_->xipos + 3 * part) - origin_of(body));
        const Matrix axes = to_link * matrix_at(data_->ximat + 9 * part);
        const mjtNum* const i = model_->body_inertia + 3 * part;
        const Matrix own = axes * (Matrix{i[0], 0, 0, 0, i[1], 0, 0, 0, i[2]} * transposed(axes));
        mass += m;
        for (std::size_t row = 0; row < 3; ++row) moment[row] += m * at[row];
        add_point(inertia, m, at);
        for (std::size_t k = 0; k < 9; ++k) inertia[k] += own[k];
      }
      const Vector centre{moment[0] / mass, moment[1] / mass, moment[2] / mass};
      add_point(inertia, -mass, centre);
      dMass total;
      dMassSetParameters(&total, mass, 0, 0, 0, inertia[0], inertia[4], inertia[8], inertia[1], inertia[2], inertia[5]);
      const dBodyID id = dBodyCreate(world_.get());
      dBodySetMass(id, &total);
      const Matrix axes = axes_of(body);
      const Vector at = origin_of(body) + axes * centre;
      dBodySetPosition(id, at[0], at[1], at[2]);
      links_.push_back({body, centre, id});
    }
  }

  /// Adds the inertia of a mass at a point.
  static void add_point(Matrix& inertia, double mass, const Vector& at) {
    const double square = at[0] * at[0] + at[1] * at[1] + at[2] * at[2];
    for (std::size_t row = 0; row < 3; ++row)
      for (std::size_t column = 0; column < 3; ++column)
        inertia[3 * row + column] += mass * ((row == column ? square : 0) - at[row] * at[column]);
  }

  void build_joints() {
    for (std::size_t motor = 0; motor < motors(); ++motor) {
      const int joint = model_->actuator_trnid[2 * motor];
      const int body = model_->jnt_bodyid[joint];
      const dJointID hinge = dJointCreateHinge(world_.get(), nullptr);
      dJointAttach(hinge, link_of(body).id, link_of(model_->body_parentid[body]).id);
      const Vector anchor = vector_at(data_->xanchor + 3 * joint), axis = vector_at(data_->xaxis + 3 * joint);
      dJointSetHingeAnchor(hinge, anchor[0], anchor[1], anchor[2]);
      dJointSetHingeAxis(hinge, axis[0], axis[1], axis[2]);
      hinges_[motor] = hinge;
    }
  }

  /// The ground and the soles.
  void build_shapes() {
    dCreatePlane(space_.get(), 0, 0, 1, 0);
    for (const char* const name : {"l_sole", "r_sole"}) {
      const int geom = mj_name2id(model_.get(), mjOBJ_GEOM, name);
      const mjtNum* const half = model_->geom_size + 3 * geom;
      const dGeomID box = dCreateBox(space_.get(), 2 * half[0], 2 * half[1], 2 * half[2]);
      const Link& link = link_of(model_->geom_bodyid[geom]);
      dGeomSetBody(box, link.id);
      const Vector at = vector_at(model_->geom_pos + 3 * geom) - link.centre;
      dGeomSetOffsetPosition(box, at[0], at[1], at[2]);
    }
  }

  /// Sets the torque of a joint: its servo's, and that of damping, dry friction and the rotor's inertia. The solver takes the
  /// last two parts at the end of the step, so they are stable however light the limb is.
  void servo(std::size_t motor) {
    const double speed = joint(motor).speed;
    const double dry = -kDryFriction * std::clamp(speed / kDrySpeed, -1.0, 1.0);
    const double resistance = kJointDamping + robot_.damping + robot_.armature / kStep;
    const double torque = torques_[motor] + dry + coupling(motor) + robot_.armature / kStep * speed;
    dJointSetHingeParam(hinges_[motor], dParamFMax, dInfinity);
    dJointSetHingeParam(hinges_[motor], dParamCFM, 1 / resistance);
    dJointSetHingeParam(hinges_[motor], dParamVel, torque / resistance);
  }

  /// The torque that keeps both hips at the same angle.
  double coupling(std::size_t motor) const {
    if (motor != kLeftHip && motor != kRightHip) return 0;
    const JointState own = joint(motor), other = joint(motor == kLeftHip ? kRightHip : kLeftHip);
    return kCoupling * (other.angle - own.angle) + kCouplingDamping * (other.speed - own.speed);
  }

  void touch(dGeomID one, dGeomID other) {
    const dBodyID first = dGeomGetBody(one), second = dGeomGetBody(other);
    std::array<dContact, kMostContacts> contacts{};
    const int count = dCollide(one, other, kMostContacts, &contacts[0].geom, sizeof(dContact));
    const double stiffness = kImpedance * kCarried / (robot_.softness * robot_.softness);
    const double damping = 2 * kImpedance * kCarried / robot_.softness;
    for (int i = 0; i < count; ++i) {
      dContact& contact = contacts[static_cast<std::size_t>(i)];
      contact.surface.mode = dContactApprox1 | dContactSoftERP | dContactSoftCFM;
      contact.surface.mu = robot_.friction;
      contact.surface.soft_erp = kStep * stiffness / (kStep * stiffness + damping);
      contact.surface.soft_cfm = 1 / (kStep * stiffness + damping);
      const dJointID joint = dJointCreateContact(world_.get(), contacts_.get(), &contact);
      dJointAttach(joint, first, second);
      if (first && second) continue;
      const dBodyID foot = first ? first : second;
      const Link& link = *std::ranges::find_if(links_, [&](const Link& l) { return l.id == foot; });
      touches_.push_back({joint, vector_at(contact.geom.pos), vector_at(contact.geom.normal), link.body});
    }
  }

  /// Shares the forces on the soles out to the nearest sensors.
  void weigh() {
    loads_ = {};
    for (const Touch& touch : touches_) {
      const dJointFeedback* const felt = dJointGetFeedback(touch.joint);
      const Vector force = dJointGetBody(touch.joint, 0) ? vector_at(felt->f1) : vector_at(felt->f2);
      const Link& link = link_of(touch.foot);
      const dReal* const m = dBodyGetRotation(link.id);
      const Matrix axes{m[0], m[1], m[2], m[4], m[5], m[6], m[8], m[9], m[10]};
      const Vector at = transposed(axes) * (touch.at - vector_at(dBodyGetPosition(link.id))) + link.centre;
      std::size_t nearest = 0;
      double least = INFINITY;
      for (std::size_t i = 0; i < sites_.size(); ++i) {
        if (model_->site_bodyid[sites_[i]] != touch.foot) continue;
        const mjtNum* const site = model_->site_pos + 3 * sites_[i];
        if (const double away = std::hypot(site[0] - at[0], site[1] - at[1]); away < least) least = away, nearest = i;
      }
      loads_[nearest] += std::abs(std::inner_product(force.begin(), force.end(), touch.normal.begin(), 0.0));
    }
  }

  Model model_;
  Data data_;
  int torso_ = 0;
  std::vector<int> sites_;  // of the foot sensors, in the order of the loads
  DrawnRobot robot_;
  std::unique_ptr<dxWorld, WorldDeleter> world_;
  std::unique_ptr<dxSpace, SpaceDeleter> space_;
  std::unique_ptr<dxJointGroup, GroupDeleter> contacts_;
  std::vector<Link> links_;
  std::array<dJointID, kLegMotors> hinges_{};
  std::vector<Touch> touches_;
  std::vector<dJointFeedback> feedback_;  // of the touches
  PerMotor torques_{};
  std::array<double, 8> loads_{};
  Vector push_{};
  double time_ = 0;
};

}  // namespace

std::unique_ptr<Engine> ode_engine(const Scene& scene) { return std::make_unique<OdeEngine>(scene); }

}  // namespace robot::nao::walk

#else

namespace robot::nao::walk {
std::unique_ptr<Engine> ode_engine(const Scene&) { return nullptr; }
}  // namespace robot::nao::walk

#endif
