#include "tests/walk/lola_body.h"

#include <algorithm>
#include <cmath>

#include "robot/nao/guardian/key_frames.h"
#include "robot/nao/motion/leg_joints.h"
#include "tests/support/lola_frame.h"
#include "tests/walk/arm_joints.h"

namespace robot::nao {
namespace {

constexpr double kStandingHip = 0.2321;  // [m] of the guardian's stand above the soles, from its angles
constexpr int kSteps = 6;                // of the physics in a cycle
constexpr int kPushSteps = 25;           // 50 ms
constexpr double kPushDuration = kPushSteps * walk::Physics::kStep;
constexpr float kHasStiffness = 0.1f;  // [0..1] of a knee

}  // namespace

LolaBody::LolaBody(const walk::DrawnRobot& robot, std::uint64_t seed, bool with_ball, bool with_arms)
    : sensors(tests::standing_sensors()),
      physics_(walk::Scene{
          .turf = robot.turf > 0, .ball = with_ball, .about_origin = robot.about_origin, .arms = with_arms}),
      stand_(legs_of(stand_pose().position)),
      with_arms_(with_arms),
      robot_(robot),
      seed_(seed) {
  sensors.position = stand_pose().position;
  sensors.stiffness.fill(0);
  physics_.reset(robot_, seed_, stand_, kStandingHip, walk::arms_of(stand_pose().position));
  sense();
}

void LolaBody::obey(const Actuators& actuators) {
  const float stiffness = actuators.stiffness[l_knee_pitch];
  held_ &= stiffness < kHasStiffness;
  // a held robot hangs upright with its feet on the ground
  physics_.command(held_ ? stand_ : legs_of(actuators.position), held_ ? 1 : stiffness,
                   walk::arms_of(held_ ? stand_pose().position : actuators.position));
  const double force = impulse_ / kPushDuration;
  for (int i = 0; i < kSteps; ++i) {
    const bool pushed = pushing_ > 0 && pushing_-- > 0;
    const double towards = direction_ + physics_.truth().heading;
    physics_.step(pushed ? force * std::cos(towards) : 0, pushed ? force * std::sin(towards) : 0);
  }
  sensors.stiffness = actuators.stiffness;
  for (std::size_t joint = 0; joint < kJoints; ++joint)
    if ((joint < l_hip_yaw_pitch || joint > r_ankle_roll) && actuators.stiffness[joint] > 0)
      sensors.position[joint] = actuators.position[joint];
  sense();
}

void LolaBody::push(double impulse, double direction) {
  impulse_ = impulse, direction_ = direction;
  pushing_ = kPushSteps;
}

void LolaBody::drop(const Drop& drop) {
  physics_.drop(robot_, seed_, legs_of(drop.limbs), walk::arms_of(drop.limbs), drop.roll, drop.pitch);
  held_ = false;
  sense();
}

bool LolaBody::upright() const {
  const walk::Truth truth = physics_.truth();
  return truth.upright > 0.5 && truth.height > 0.2;
}

void LolaBody::sense() {
  const walk::Sensors from = physics_.sense();
  std::copy(from.rate.begin(), from.rate.end(), sensors.gyroscope.begin());
  sensors.angles = {static_cast<float>(from.roll), static_cast<float>(from.pitch)};
  for (std::size_t i = 0; i < sensors.fsr.size(); ++i) sensors.fsr[i] = static_cast<float>(from.load[i / 4][i % 4]);
  put_legs(from.joints, sensors.position);
  if (with_arms_) walk::put_arms(physics_.arms(), sensors.position);
}

}  // namespace robot::nao
