#include "tests/support/planted_offset.h"

#include <algorithm>
#include <cmath>
#include <memory>
#include <numbers>
#include <random>

namespace tests {
namespace {

constexpr double kStep = 0.005;  // [s] of the simulated motion

class Chance {
 public:
  explicit Chance(std::uint32_t seed) : random_(seed) {}
  double uniform() { return (static_cast<double>(random_()) + 0.5) / 4294967296.0; }
  /// Box and Muller.
  double normal() { return std::sqrt(-2 * std::log(uniform())) * std::cos(2 * std::numbers::pi * uniform()); }

 private:
  std::mt19937 random_;
};

/// A robot that follows the ball and kicks it now and then.
class Chase {
 public:
  Chase(bool kicks, Chance& chance) : kicks_(kicks), chance_(chance) { next_kick_ = 3 + 2 * chance_.uniform(); }

  double distance() const { return std::hypot(ball_x_ - robot_x_, ball_y_ - robot_y_); }

  /// Returns the distance with the errors of ground truth.
  double measured_distance() {
    const double x = ball_x_ - robot_x_ + 0.01 * chance_.normal() + 0.02 * chance_.normal();
    const double y = ball_y_ - robot_y_ + 0.01 * chance_.normal() + 0.02 * chance_.normal();
    return std::hypot(x, y);
  }

  void step(double now) {
    walk();
    roll();
    if (kicks_ && now > next_kick_ && distance() < 0.5) kick(now);
  }

 private:
  void walk() {
    const double far = distance(), speed = far > 0.25 ? std::min(0.25, far) : 0;
    if (far == 0) return;
    robot_x_ += (ball_x_ - robot_x_) / far * speed * kStep;
    robot_y_ += (ball_y_ - robot_y_) / far * speed * kStep;
  }

  void roll() {
    const double speed = std::hypot(speed_x_, speed_y_);
    const double left = speed > 0 ? std::max(0.0, 1 - 0.27 * kStep / speed) : 0;
    speed_x_ *= left, speed_y_ *= left;
    ball_x_ += speed_x_ * kStep, ball_y_ += speed_y_ * kStep;
    // a board around the place
    if (const double out = std::hypot(ball_x_, ball_y_); out > 2.2) {
      ball_x_ *= 2.2 / out, ball_y_ *= 2.2 / out;
      speed_x_ *= -0.3, speed_y_ *= -0.3;
    }
  }

  void kick(double now) {
    const double angle = 2 * std::numbers::pi * chance_.uniform(), speed = 1.2 + 0.15 * chance_.normal();
    speed_x_ = speed * std::cos(angle), speed_y_ = speed * std::sin(angle);
    next_kick_ = now + 6 + 4 * chance_.uniform();
  }

  const bool kicks_;
  Chance& chance_;
  double next_kick_ = 0;
  double robot_x_ = 0, robot_y_ = 0, ball_x_ = 1, ball_y_ = 0.3, speed_x_ = 0, speed_y_ = 0;
};

}  // namespace

PlantedDistances planted_distances(const PlantedPlan& plan) {
  Chance chance(plan.seed);
  Chase chase(plan.kicks, chance);
  PlantedDistances distances;
  double next_truth = 0, next_image = 0.01, slow = 0;
  for (double now = 0; now < plan.seconds; now += kStep) {
    chase.step(now);
    if (now >= next_truth) {
      distances.truth.push_back({.at = now + 0.004 * chance.normal(), .value = chase.measured_distance()});
      next_truth += 1 / plan.truth_rate;
    }
    if (now >= next_image) {
      slow = 0.9 * slow + std::sqrt(1 - 0.81) * 0.08 * chance.normal();
      const double outlier = chance.uniform() < 0.02 ? 0.5 * chance.normal() : 0, distance = chase.distance();
      if (distance < 3 && chance.uniform() > 0.1)
        distances.seen.push_back({.at = (now + 0.003 * chance.normal()) * (1 + plan.drift) + plan.offset,
                                  .value = 1.06 * distance + 0.03 + slow * distance / 1.5 + outlier});
      next_image += 1 / 30.0;
    }
  }
  return distances;
}

robot::lab::SharedDistance shared_distance(const PlantedDistances& distances) {
  return {.truth = std::make_shared<robot::lab::SmoothCurve>(robot::lab::tidied(distances.truth)),
          .seen = robot::lab::tidied(distances.seen)};
}

}  // namespace tests
