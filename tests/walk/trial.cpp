#include "tests/walk/trial.h"

#include <algorithm>
#include <cmath>

#include "robot/nao/guardian/limiter.h"
#include "robot/nao/motion/leg_joints.h"

namespace robot::nao::walk {
namespace {

constexpr double kBlow = 0.05;    // [s] duration of a push
constexpr double kSampled = 0.2;  // [s] from one sample of the pose to the next
constexpr double kWarmUp = 2;     // [s] until the displacements count
constexpr double kFallen = 0.5;   // cosine of 60°
constexpr double kLowest = 0.2;   // [m]

/// The guardian's limiter for the legs.
class LimitedLegs {
 public:
  explicit LimitedLegs(const Legs& start) {
    target_.stiffness.fill(1);
    put_legs(start, target_.position);
    limiter_.start(target_);
  }

  /// Returns the targets that the limiter lets pass, `dt` [s] after the last ones.
  Legs next(const Legs& wanted, double dt) {
    put_legs(wanted, target_.position);
    return legs_of(limiter_.next(target_, target_.position, static_cast<float>(dt), 1).position);
  }

 private:
  Pose target_;
  Limiter limiter_;
};

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
  Outcome outcome;
  Odometer odometer(physics.truth());
  double next_frame = 0, next_sample = kSampled;
  bool ball_lies = false;
  LimitedLegs limiter(stand);
  while (physics.now() < plan.duration) {
    const double now = physics.now();
    if (now >= next_frame - 1e-9) {
      next_frame += plan.dt;
      physics.command(limiter.next(gait.tick(physics.sense(), plan.command(now), plan.dt), plan.dt));
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
