#include "tests/walk/physics.h"

#include <mujoco/mujoco.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <mutex>
#include <string>

namespace robot::nao::walk {
namespace {

constexpr double kGravity = 9.81;          // [m/s²]
constexpr double kTorsoAboveHip = 0.085;   // [m] from the hips to the origin of the torso
constexpr double kAngleNoise = 0.003;      // [rad]
constexpr double kLoadNoise = 0.02;        // [kg]
constexpr double kBallDeceleration = 0.3;  // [m/s²] on carpet: sim/data/models/match.json
constexpr double kDroppedFrom = 0.25;      // [m] height of the torso
constexpr double kRests = 0.02;            // [m/s] a slower ball comes to rest softly
constexpr std::array<const char*, kLegJoints> kNames = {"HipYawPitch", "HipRoll",    "HipPitch",
                                                        "KneePitch",   "AnklePitch", "AnkleRoll"};
constexpr std::array<const char*, kArmJoints> kArmNames = {"ShoulderPitch", "ShoulderRoll", "ElbowYaw", "ElbowRoll"};
// by joint: speeds without load and torques of the motors with their gears
constexpr std::array<double, kLegJoints> kSpeed = {4.16, 4.16, 6.4, 6.4, 6.4, 4.16};      // [rad/s]
constexpr std::array<double, kLegJoints> kTorque = {13.69, 13.69, 8.9, 8.9, 8.9, 13.69};  // [N m]
constexpr std::array<double, kArmJoints> kArmSpeed = {8.27, 7.19, 8.27, 7.19};            // [rad/s]
constexpr std::array<double, kArmJoints> kArmTorque = {2.149, 2.477, 2.149, 2.477};       // [N m]
constexpr double kArmShare = 0.22;  // gain, damping and armature of an arm's servo, of those of a leg: as their torques

/// Loads the model through a file in memory. One thread at a time: the table of files is too large for a stack.
mjModel* load(const std::string& xml) {
  static std::mutex one_at_a_time;
  const std::lock_guard lock(one_at_a_time);
  static mjVFS files;
  mj_defaultVFS(&files);
  mj_makeEmptyFileVFS(&files, "nao.xml", static_cast<int>(xml.size()));
  std::memcpy(files.filedata[0], xml.data(), xml.size());
  std::array<char, 1000> problem{};
  mjModel* const model = mj_loadXML("nao.xml", &files, problem.data(), problem.size());
  mj_deleteVFS(&files);
  if (model) return model;
  std::fprintf(stderr, "the model of the Nao: %s\n", problem.data());
  std::abort();
}

double heading_of(const mjtNum* rotation) { return std::atan2(rotation[3], rotation[0]); }

}  // namespace

Physics::Physics(const Scene& scene)
    : model_(load(model_of(scene)), mj_deleteModel),
      data_(mj_makeData(model_.get()), mj_deleteData),
      has_arms_(scene.arms) {
  const auto find = [&](Side side, const char* joint, int& position, int& speed) {
    const std::string name = (side == left ? "L" : "R") + std::string(joint);
    const int id = mj_name2id(model_.get(), mjOBJ_JOINT, name.c_str());
    position = model_->jnt_qposadr[id], speed = model_->jnt_dofadr[id];
  };
  for (const Side side : {left, right}) {
    for (std::size_t joint = 0; joint < kLegJoints; ++joint)
      find(side, kNames[joint], position_[side][joint], speed_[side][joint]);
    for (std::size_t joint = 0; has_arms_ && joint < kArmJoints; ++joint)
      find(side, kArmNames[joint], arm_position_[side][joint], arm_speed_[side][joint]);
  }
  torso_ = mj_name2id(model_.get(), mjOBJ_BODY, "torso");
  ball_ = mj_name2id(model_.get(), mjOBJ_BODY, "ball");
}

Physics::~Physics() = default;

void Physics::reset(const DrawnRobot& robot, std::uint64_t seed, const Legs& legs, double hip_height,
                    const Arms& arms) {
  robot_ = robot;
  dice_ = Dice(seed * 2654435761u + 17);
  mjModel& model = *model_;
  for (const Side side : {left, right})
    for (const int dof : speed_[side]) {
      model.dof_damping[dof] = 0.1 + robot.damping;
      model.dof_armature[dof] = robot.armature;
    }
  if (has_arms_)
    for (const Side side : {left, right})
      for (const int dof : arm_speed_[side]) {
        model.dof_damping[dof] = 0.1 + kArmShare * robot.damping;
        model.dof_armature[dof] = kArmShare * robot.armature;
      }
  for (int geom = 0; geom < model.ngeom; ++geom) {
    const bool floor = geom == 0, round = model.geom_type[geom] == mjGEOM_SPHERE;
    // MuJoCo takes the greater friction of both sides
    model.geom_friction[3 * geom] = floor ? 0.01 : round ? 0.5 : robot.friction;
    if (!round) model.geom_solref[2 * geom] = robot.softness;
  }
  if (model.nhfield > 0)
    for (int i = 0; i < model.hfield_nrow[0] * model.hfield_ncol[0]; ++i)
      model.hfield_data[i] = static_cast<float>(dice_.uniform() * robot.turf / kTurfHeight);

  mjData& data = *data_;
  mj_resetData(&model, &data);
  for (const Side side : {left, right}) {
    for (std::size_t joint = 0; joint < kLegJoints; ++joint) data.qpos[position_[side][joint]] = legs[side][joint];
    for (std::size_t joint = 0; has_arms_ && joint < kArmJoints; ++joint)
      data.qpos[arm_position_[side][joint]] = arms[side][joint];
  }
  data.qpos[2] = hip_height + kTorsoAboveHip + 0.002 + robot.turf;
  if (model.nhfield > 0) data.qpos[0] = -4, data.qpos[1] = -3 + 6 * dice_.uniform();
  mj_forward(&model, &data);
  queue_.clear();
  target_ = {.legs = legs, .arms = arms};
  roll_ = pitch_ = sensed_at_ = 0;
}

void Physics::drop(const DrawnRobot& robot, std::uint64_t seed, const Legs& legs, const Arms& arms, double roll,
                   double pitch) {
  reset(robot, seed, legs, 0, arms);
  mjData& data = *data_;
  data.qpos[2] = kDroppedFrom;
  // first about the torso's x, then about the world's y
  const double a = std::cos(pitch / 2), b = std::sin(pitch / 2), c = std::cos(roll / 2), d = std::sin(roll / 2);
  mjtNum* const rotation = data.qpos + 3;
  rotation[0] = a * c, rotation[1] = a * d, rotation[2] = b * c, rotation[3] = -b * d;
  mj_forward(model_.get(), data_.get());
  pitch_ = pitch, roll_ = roll;
}

Sensors Physics::sense() {
  Sensors sensors;
  const mjData& data = *data_;
  const double dt = data.time - sensed_at_;
  sensed_at_ = data.time;
  for (std::size_t i = 0; i < 3; ++i)
    sensors.rate[i] = data.sensordata[i] + robot_.rate_bias[i] + robot_.rate_noise * dice_.normal();

  const mjtNum* const rotation = data.xmat + 9 * torso_;  // by rows; its columns are the axes of the torso
  const double share = robot_.angle_lag > 0 ? dt / (dt + robot_.angle_lag) : 1;
  pitch_ += share * (std::asin(std::clamp(-rotation[6], -1.0, 1.0)) - pitch_);
  roll_ += share * (std::atan2(rotation[7], rotation[8]) - roll_);
  sensors.pitch = pitch_ + robot_.pitch_bias + kAngleNoise * dice_.normal();
  sensors.roll = roll_ + robot_.roll_bias + kAngleNoise * dice_.normal();

  for (std::size_t i = 0; i < 8; ++i)
    sensors.load[i / 4][i % 4] =
        std::max(0.0, robot_.load_gain[i] * data.sensordata[3 + i] / kGravity + kLoadNoise * dice_.normal());
  for (const Side side : {left, right})
    for (std::size_t joint = 0; joint < kLegJoints; ++joint)
      sensors.joints[side][joint] = data.qpos[position_[side][joint]] + robot_.offset[side][joint];
  return sensors;
}

void Physics::command(const Legs& targets, double stiffness, const Arms& arms) {
  queue_.push_back({data_->time + robot_.delay, targets, stiffness, arms});
}

/// Returns the torque of a servo that is `error` [rad] away. A motor has less torque at speed.
double Physics::torque(double error, double speed, double stiffness, double share, double most, double fastest) const {
  const double half = robot_.play / 2;
  error -= std::clamp(error, -half, half);
  const double wanted = stiffness * share * robot_.gain * error;
  const double left_over = std::clamp(1 - std::copysign(1.0, wanted) * speed / fastest, 0.0, 1.0);
  const double limit = most * robot_.torque * left_over;
  return std::clamp(wanted, -limit, limit);
}

void Physics::step(double force_x, double force_y) {
  mjData& data = *data_;
  while (!queue_.empty() && queue_.front().time <= data.time + 1e-9) {
    target_ = queue_.front();
    queue_.pop_front();
  }
  for (const Side side : {left, right}) {
    for (std::size_t joint = 0; joint < kLegJoints; ++joint) {
      const double error = target_.legs[side][joint] - robot_.offset[side][joint] - data.qpos[position_[side][joint]];
      data.ctrl[side * kLegJoints + static_cast<int>(joint)] =
          torque(error, data.qvel[speed_[side][joint]], target_.stiffness, 1, kTorque[joint], kSpeed[joint]);
    }
    for (std::size_t joint = 0; has_arms_ && joint < kArmJoints; ++joint) {
      const double error = target_.arms[side][joint] - data.qpos[arm_position_[side][joint]];
      data.ctrl[2 * kLegJoints + side * kArmJoints + static_cast<int>(joint)] = torque(
          error, data.qvel[arm_speed_[side][joint]], target_.stiffness, kArmShare, kArmTorque[joint], kArmSpeed[joint]);
    }
  }
  mjtNum* const force = data.xfrc_applied + 6 * torso_;
  force[0] = force_x, force[1] = force_y;
  if (ball_ >= 0) slow_ball();
  mj_step(model_.get(), data_.get());
}

/// Lets the carpet slow a rolling ball.
void Physics::slow_ball() {
  mjData& data = *data_;
  const mjtNum* const velocity = data.qvel + model_->jnt_dofadr[model_->body_jntadr[ball_]];
  const double speed = std::hypot(velocity[0], velocity[1]);
  // it also slows the ball's turning
  const double turns = model_->body_inertia[3 * ball_] / (kBallRadius * kBallRadius);
  const double force = (model_->body_mass[ball_] + turns) * kBallDeceleration * std::min(1.0, speed / kRests);
  mjtNum* const applied = data.xfrc_applied + 6 * ball_;
  applied[0] = speed > 0 ? -force * velocity[0] / speed : 0;
  applied[1] = speed > 0 ? -force * velocity[1] / speed : 0;
}

Truth Physics::truth() const {
  const mjData& data = *data_;
  const mjtNum* const rotation = data.xmat + 9 * torso_;
  Truth truth{.x = data.qpos[0],
              .y = data.qpos[1],
              .height = data.qpos[2],
              .heading = heading_of(rotation),
              .upright = rotation[8],
              .face_up = rotation[6]};
  // the torso's z axis points where it tips
  truth.fall_direction = std::remainder(std::atan2(rotation[5], rotation[2]) - truth.heading, 2 * M_PI);
  if (ball_ >= 0) {
    const int joint = model_->body_jntadr[ball_], dof = model_->jnt_dofadr[joint];
    truth.ball_x = data.qpos[model_->jnt_qposadr[joint]], truth.ball_y = data.qpos[model_->jnt_qposadr[joint] + 1];
    truth.ball_speed = std::hypot(data.qvel[dof], data.qvel[dof + 1]);
    truth.ball_direction = std::remainder(std::atan2(data.qvel[dof + 1], data.qvel[dof]) - truth.heading, 2 * M_PI);
  }
  return truth;
}

Arms Physics::arms() const {
  Arms arms{};
  for (const Side side : {left, right})
    for (std::size_t joint = 0; has_arms_ && joint < kArmJoints; ++joint)
      arms[side][joint] = data_->qpos[arm_position_[side][joint]];
  return arms;
}

double Physics::now() const { return data_->time; }

void Physics::place_ball(double ahead, double left_of, double speed) {
  const int joint = model_->body_jntadr[ball_];
  const Truth robot = truth();
  const double cosine = std::cos(robot.heading), sine = std::sin(robot.heading);
  mjtNum* const place = data_->qpos + model_->jnt_qposadr[joint];
  place[0] = robot.x + ahead * cosine - left_of * sine;
  place[1] = robot.y + ahead * sine + left_of * cosine;
  place[2] = kBallRadius;
  mjtNum* const velocity = data_->qvel + model_->jnt_dofadr[joint];
  std::fill_n(velocity, 6, 0.0);
  velocity[0] = speed * cosine, velocity[1] = speed * sine;
  // it rolls; angular velocities are in the ball's own frame
  place[3] = 1, place[4] = place[5] = place[6] = 0;
  velocity[3] = -velocity[1] / kBallRadius, velocity[4] = velocity[0] / kBallRadius;
}

}  // namespace robot::nao::walk
