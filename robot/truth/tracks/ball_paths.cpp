#include "robot/truth/tracks/ball_paths.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "robot/truth/tracks/gates.h"
#include "robot/truth/tracks/motion.h"

namespace robot::truth {
namespace {

constexpr double kKicksPerSecond = 0.3;  // of a game; rebounds included
constexpr double kNotABall = 0.01;       // [1/m²] density of measurements near the ball that show something else
constexpr double kLeastLogWeight = -14;  // less likely paths are given up
constexpr unsigned kRemembered = 6;      // paths that differ only in older events are one

/// One way to continue one path.
struct Continuation {
  std::size_t parent = 0;
  BallEvent event{};
  double log_weight = -std::numeric_limits<double>::infinity();
};
using Continuations = std::array<Continuation, 3 * kMostPaths>;

double log_probability(BallEvent event, double dt) {
  const double kick = std::min(0.5, kKicksPerSecond * dt);
  return event == BallEvent::kicked ? std::log(kick) : std::log(1 - kick);
}

std::uint16_t remembered(std::uint16_t recent, BallEvent event) {
  constexpr unsigned mask = (1u << 2 * kRemembered) - 1;
  return static_cast<std::uint16_t>((unsigned{recent} << 2 | static_cast<unsigned>(event)) & mask);
}

}  // namespace

Step ball_event_step(const Estimate& ball, const SharedErrors& shared, double dt, BallEvent event) {
  Step step = ball_step(ball, shared, dt);
  if (event == BallEvent::kicked) add_kick(step, dt);
  return step;
}

BallPaths::BallPaths(const Measurement& first, const SharedErrors& shared) {
  paths_[0].estimate = first_estimate(first, shared, kKickSpeed);
}

bool BallPaths::explains(const Measurement& measurement, const SharedErrors& shared, double dt) const {
  return std::any_of(paths_.begin(), paths_.begin() + count_, [&](const Path& path) {
    const Step kick = ball_event_step(path.estimate, shared, dt, BallEvent::kicked);
    return innovation(predicted(path.estimate, kick), measurement).distance_squared <= kGate;
  });
}

void BallPaths::advance(const Measurement& measurement, const SharedErrors& shared, double dt) {
  // each path continues in three ways
  std::array<std::array<Estimate, 2>, kMostPaths> moved;
  Continuations all;
  for (std::size_t i = 0; i < count_; ++i) {
    for (const BallEvent event : {BallEvent::rolled, BallEvent::kicked}) {
      Estimate& next = moved[i][static_cast<std::size_t>(event)];
      next = predicted(paths_[i].estimate, ball_event_step(paths_[i].estimate, shared, dt, event));
      all[3 * i + static_cast<std::size_t>(event)] = {
          i, event, paths_[i].log_weight + log_probability(event, dt) + innovation(next, measurement).log_density};
    }
    all[3 * i + 2] = {i, BallEvent::not_a_ball, paths_[i].log_weight + std::log(kNotABall)};
  }
  std::stable_sort(all.begin(), all.end(),
                   [](const Continuation& a, const Continuation& b) { return a.log_weight > b.log_weight; });

  // the most likely ones stay, unless they repeat a better one
  const std::array<Path, kMostPaths> before = paths_;
  count_ = 0;
  for (const Continuation& one : all) {
    if (count_ == kMostPaths || !(one.log_weight > all[0].log_weight + kLeastLogWeight)) break;
    const std::uint16_t recent = remembered(before[one.parent].recent, one.event);
    const auto repeats = [&](const Path& path) { return path.recent == recent; };
    if (std::any_of(paths_.begin(), paths_.begin() + count_, repeats)) continue;

    Path& path = paths_[count_++];
    path = {.estimate = moved[one.parent][one.event == BallEvent::kicked],
            .log_weight = one.log_weight - all[0].log_weight,
            .event = one.event,
            .parent = static_cast<std::uint8_t>(one.parent),
            .recent = recent};
    if (one.event != BallEvent::not_a_ball)
      correct(path.estimate, measurement, std::numeric_limits<double>::infinity());
  }
}

Estimate BallPaths::mixture() const {
  double sum = 0;
  Estimate mixed;
  for (std::size_t i = 0; i < count_; ++i) {
    const double weight = std::exp(paths_[i].log_weight);
    sum += weight;
    mixed.mean += weight * paths_[i].estimate.mean;
  }
  mixed.mean /= sum;
  for (std::size_t i = 0; i < count_; ++i) {
    const Estimate::Mean apart = paths_[i].estimate.mean - mixed.mean;
    mixed.covariance +=
        std::exp(paths_[i].log_weight) / sum * (paths_[i].estimate.covariance + apart * apart.transpose());
  }
  return mixed;
}

}  // namespace robot::truth
