#include <mujoco/mujoco.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "tests/walk/engine.h"
#include "tests/walk/mujoco_model.h"

namespace robot::nao::walk {
namespace {

constexpr double kBallDeceleration = 0.3;  // [m/s²] on carpet: sim/data/models/match.json
constexpr double kRests = 0.02;            // [m/s] a slower ball comes to rest softly

class MujocoEngine final : public Engine {
 public:
  explicit MujocoEngine(const Scene& scene)
      : model_(load_model(scene)),
        data_(mj_makeData(model_.get())),
        motors_(static_cast<std::size_t>(model_->nu)),
        torso_(mj_name2id(model_.get(), mjOBJ_BODY, "torso")),
        ball_(mj_name2id(model_.get(), mjOBJ_BODY, "ball")) {
    for (std::size_t motor = 0; motor < motors_; ++motor) {
      const int joint = model_->actuator_trnid[2 * motor];
      position_[motor] = model_->jnt_qposadr[joint], speed_[motor] = model_->jnt_dofadr[joint];
    }
  }

  void reset(const DrawnRobot& robot, Dice& dice, const PerMotor& angles, double torso_height) override {
    mjModel& model = *model_;
    for (std::size_t motor = 0; motor < motors_; ++motor) {
      const double share = motor < kLegMotors ? 1 : kArmShare;
      model.dof_damping[speed_[motor]] = kJointDamping + share * robot.damping;
      model.dof_armature[speed_[motor]] = share * robot.armature;
    }
    for (int geom = 0; geom < model.ngeom; ++geom) {
      const bool floor = geom == 0, round = model.geom_type[geom] == mjGEOM_SPHERE;
      // MuJoCo takes the greater friction of both sides
      model.geom_friction[3 * geom] = floor ? 0.01 : round ? 0.5 : robot.friction;
      if (!round) model.geom_solref[2 * geom] = robot.softness;
    }
    if (model.nhfield > 0)
      for (int i = 0; i < model.hfield_nrow[0] * model.hfield_ncol[0]; ++i)
        model.hfield_data[i] = static_cast<float>(dice.uniform() * robot.turf / kTurfHeight);

    mjData& data = *data_;
    mj_resetData(&model, &data);
    for (std::size_t motor = 0; motor < motors_; ++motor) data.qpos[position_[motor]] = angles[motor];
    data.qpos[2] = torso_height;
    if (model.nhfield > 0) data.qpos[0] = -4, data.qpos[1] = -3 + 6 * dice.uniform();
    mj_forward(&model, &data);
  }

  void turn(double torso_height, const std::array<double, 4>& rotation) override {
    data_->qpos[2] = torso_height;
    std::copy(rotation.begin(), rotation.end(), data_->qpos + 3);
    mj_forward(model_.get(), data_.get());
  }

  void step() override {
    if (ball_ >= 0) slow_ball();
    mj_step(model_.get(), data_.get());
  }

  double now() const override { return data_->time; }
  std::size_t motors() const override { return motors_; }
  JointState joint(std::size_t motor) const override {
    return {data_->qpos[position_[motor]], data_->qvel[speed_[motor]]};
  }
  void drive(std::size_t motor, double torque) override { data_->ctrl[motor] = torque; }
  void push(double x, double y) override {
    mjtNum* const force = data_->xfrc_applied + 6 * torso_;
    force[0] = x, force[1] = y;
  }

  std::array<double, 3> position() const override { return {data_->qpos[0], data_->qpos[1], data_->qpos[2]}; }
  std::array<double, 9> rotation() const override {
    std::array<double, 9> rotation{};
    std::copy_n(data_->xmat + 9 * torso_, 9, rotation.begin());
    return rotation;
  }
  std::array<double, 3> rate() const override {
    return {data_->sensordata[0], data_->sensordata[1], data_->sensordata[2]};
  }
  std::array<double, 8> loads() const override {
    std::array<double, 8> loads{};
    std::copy_n(data_->sensordata + 3, 8, loads.begin());
    return loads;
  }

  bool has_ball() const override { return ball_ >= 0; }
  RollingBall ball() const override {
    const mjtNum* const place = data_->qpos + ball_position();
    const mjtNum* const velocity = data_->qvel + ball_velocity();
    return {place[0], place[1], velocity[0], velocity[1]};
  }
  void place(const RollingBall& ball) override {
    mjtNum* const place = data_->qpos + ball_position();
    mjtNum* const velocity = data_->qvel + ball_velocity();
    std::fill_n(velocity, 6, 0.0);
    place[0] = ball.x, place[1] = ball.y, place[2] = kBallRadius;
    velocity[0] = ball.vx, velocity[1] = ball.vy;
    // it rolls; angular velocities are in the ball's own frame
    place[3] = 1, place[4] = place[5] = place[6] = 0;
    velocity[3] = -velocity[1] / kBallRadius, velocity[4] = velocity[0] / kBallRadius;
  }

 private:
  int ball_position() const { return model_->jnt_qposadr[model_->body_jntadr[ball_]]; }
  int ball_velocity() const { return model_->jnt_dofadr[model_->body_jntadr[ball_]]; }

  /// Lets the carpet slow a rolling ball.
  void slow_ball() {
    const mjtNum* const velocity = data_->qvel + ball_velocity();
    const double speed = std::hypot(velocity[0], velocity[1]);
    // it also slows the ball's turning
    const double turns = model_->body_inertia[3 * ball_] / (kBallRadius * kBallRadius);
    const double force = (model_->body_mass[ball_] + turns) * kBallDeceleration * std::min(1.0, speed / kRests);
    mjtNum* const applied = data_->xfrc_applied + 6 * ball_;
    applied[0] = speed > 0 ? -force * velocity[0] / speed : 0;
    applied[1] = speed > 0 ? -force * velocity[1] / speed : 0;
  }

  Model model_;
  Data data_;
  std::size_t motors_;
  int torso_, ball_;                               // bodies
  std::array<int, kMotors> position_{}, speed_{};  // addresses of the joints in qpos and qvel
};

}  // namespace

std::unique_ptr<Engine> mujoco_engine(const Scene& scene) { return std::make_unique<MujocoEngine>(scene); }

}  // namespace robot::nao::walk
