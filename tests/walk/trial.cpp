#include "tests/walk/trial.h"

#include <algorithm>
#include <cmath>

#include "robot/nao/lola/joints.h"

namespace robot::nao::walk {
namespace {

constexpr double kBlow = 0.05;    // [s] duration of a push
constexpr double kSampled = 0.2;  // [s] from one sample of the pose to the next
constexpr double kWarmUp = 2;     // [s] until the displacements count
constexpr double kFallen = 0.5;   // cosine of 60°
constexpr double kLowest = 0.2;   // [m]

constexpr std::array<std::array<Joint, kLegJoints>, 2> kJoints = {{
    {l_hip_yaw_pitch, l_hip_roll, l_hip_pitch, l_knee_pitch, l_ankle_pitch, l_ankle_roll},
    {l_hip_yaw_pitch, r_hip_roll, r_hip_pitch, r_knee_pitch, r_ankle_pitch, r_ankle_roll},
}};

/// Returns the targets as the guardian's limiter lets them pass: within the ranges and speeds of the joints.
Legs limited(const Legs& last, const Legs& wanted, double dt) {
  Legs passed;
  for (const Side side : {left, right})
    for (std::size_t joint = 0; joint < kLegJoints; ++joint) {
      const JointLimits& limits = limits_of(kJoints[side][joint]);
      const double most = limits.speed * dt, before = last[side][joint];
      passed[side][joint] = std::clamp(std::clamp(wanted[side][joint], before - most, before + most),
                                       double{limits.range.low}, double{limits.range.high});
    }
  return passed;
}

/// Sums the displacements of the torso, and the time in which it was too slow.
class Odometer {
 public:
  explicit Odometer(const Truth& start) : last_(start) {}

  void see(const Truth& now, double wanted, bool counts, Outcome& outcome) {
    const double x = now.x - last_.x, y = now.y - last_.y;
    const double ahead = x * std::cos(now.heading) + y * std::sin(now.heading);
    if (counts) {
      outcome.forward += ahead;
      outcome.left += y * std::cos(now.heading) - x * std::sin(now.heading);
      outcome.turned += std::remainder(now.heading - last_.heading, 2 * M_PI);
      outcome.path += std::hypot(x, y);
      outcome.measured += kSampled;
    }
    // over a second, because steps are uneven
    progress_.push_back(ahead);
    if (progress_.size() > 5) progress_.erase(progress_.begin());
    double second = 0;
    for (const double way : progress_) second += way;
    slow_ = wanted > 0 && counts && second < 0.5 * wanted ? slow_ + kSampled : 0;
    outcome.slow = std::max(outcome.slow, slow_);
    last_ = now;
  }

 private:
  Truth last_;
  std::vector<double> progress_;
  double slow_ = 0;
};

}  // namespace

Outcome run(Physics& physics, Gait& gait, const DrawnRobot& robot, std::uint64_t seed, const Legs& stand,
            double hip_height, const Plan& plan) {
  physics.reset(robot, seed, stand, hip_height);
  if (plan.box_ahead > 0) physics.place_box(plan.box_ahead, plan.box_aside);
  Outcome outcome;
  Odometer odometer(physics.truth());
  double next_frame = 0, next_sample = kSampled;
  bool ball_lies = false;
  Legs targets = stand;
  while (physics.now() < plan.duration) {
    const double now = physics.now();
    if (now >= next_frame - 1e-9) {
      next_frame += plan.dt;
      targets = limited(targets, gait.tick(physics.sense(), plan.command(now), plan.dt), plan.dt);
      physics.command(targets);
      if (gait.steps()) outcome.last_step = now;
    }
    if (plan.with_ball && gait.kicks() && !ball_lies) {
      physics.place_ball(plan.ball_ahead, plan.ball_left);
      ball_lies = true;
    }

    double force = 0, direction = 0;
    for (const Push& push : plan.pushes)
      if (now >= push.time && now < push.time + kBlow)
        force = push.impulse / kBlow, direction = push.direction + physics.truth().heading;
    physics.step(force * std::cos(direction), force * std::sin(direction));

    const Truth truth = physics.truth();
    if (now >= next_sample - 1e-9) {
      odometer.see(truth, plan.command(now).forward, now > kWarmUp, outcome);
      next_sample += kSampled;
    }
    if (ball_lies && truth.ball_speed > outcome.ball_speed)
      outcome.ball_speed = truth.ball_speed, outcome.ball_direction = truth.ball_direction;
    if (truth.upright < kFallen || truth.height < kLowest || !(truth.height < 10)) {
      outcome.fell = true, outcome.direction = truth.fall_direction;
      break;
    }
  }
  outcome.time = physics.now();
  return outcome;
}

}  // namespace robot::nao::walk
