#include "tests/support/planted_looks.h"

#include <algorithm>
#include <cmath>
#include <random>

#include "robot/fit/visibility/detection.h"

namespace robot::tests {
namespace {

constexpr double kHeight = 0.4, kWidth = 0.983, kUpper = 0.06, kLower = 1.4, kFarRange = 6;

/// Draws a false ball as sim/perception/ball_sight.cpp does in each tenth image.
void draw_false_ball(const PlantedLooks& planted, std::mt19937_64& random, fit::Look& look) {
  std::uniform_real_distribution<double> uniform;
  if (uniform(random) >= planted.false_per_second / 3) return;
  const double range = 0.3 + uniform(random) * (kFarRange - 0.3), side = look.axis + kWidth * (uniform(random) - 0.5);
  if (range < look.nearest || range > look.farthest) return;
  look.has_ball = true, look.seen_x = range * std::cos(side), look.seen_y = range * std::sin(side);
}

}  // namespace

sim::Models planted_base() {
  sim::Models base{};
  base.effects.ball_noise = true;
  base.ball.radius = 0.05f;
  base.contact.hiding_radius = 0.11f;
  base.perception.camera = {.height = 0.45f,
                            .width = 0.983f,
                            .upper_edge = -0.36f,
                            .lower_edge = 1.074f,
                            .pixel_angle = 0.00154f,
                            .latency = 0.07f};
  base.perception.ball = {.near = 0.9f, .far = 0.15f, .near_range = 3.5f, .far_range = 6};
  base.perception.noise = {.pixels = 2, .tilt = 0.02f, .tilt_walking = 0.03f, .roll = 0.02f};
  base.perception.filter.false_per_second = 0.015f;
  return base;
}

fit::Sights planted_detections(const PlantedDetections& planted, std::uint64_t seed) {
  std::mt19937_64 random(seed);
  std::normal_distribution<double> normal;
  std::uniform_real_distribution<double> uniform;
  const fit::DetectionCurve curve{
      .near = planted.near, .far = planted.far, .near_range = planted.near_range, .far_range = planted.far_range};
  fit::Sights found{.recordings = {"one", "two"}, .error = planted.truth_error};
  for (std::size_t pass = 0; pass < planted.passes; ++pass) {
    double distance = planted.nearest + (planted.farthest - planted.nearest) * uniform(random);
    const double rate = 0.6 * uniform(random) - 0.3;
    const bool hidden = uniform(random) < planted.hidden;
    for (std::size_t i = 0; i < planted.images; ++i) {
      distance = std::clamp(distance + rate / 30, planted.nearest, planted.farthest);
      const double plausible = 1 - 0.02 * distance;
      found.sights.push_back({.recording = pass % 10 < 5 ? 0u : 1u,
                              .at = 3 * static_cast<double>(pass) + static_cast<double>(i) / 30,
                              .distance = std::max(0.1, distance + planted.truth_error * normal(random)),
                              .off_axis = 0.4 * uniform(random),
                              .head_speed = uniform(random),
                              .hidden = hidden,
                              .seen = !hidden && uniform(random) < plausible * curve.probability(distance),
                              .plausible = plausible});
    }
  }
  std::ranges::stable_sort(found.sights, {}, &fit::Sight::recording);
  return found;
}

fit::Sights planted_logistic(const fit::Logistic::Features& weights, std::size_t passes, std::uint64_t seed) {
  std::mt19937_64 random(seed);
  std::uniform_real_distribution<double> uniform;
  const fit::Logistic model{.weights = weights};
  fit::Sights found{.recordings = {"planted"}};
  for (std::size_t pass = 0; pass < passes; ++pass) {
    const double distance = 0.4 + 5 * uniform(random);
    const bool hidden = uniform(random) < 0.3;
    for (int i = 0; i < 40; ++i) {
      fit::Sight sight{.at = 3 * static_cast<double>(pass) + i / 30.,
                       .distance = distance,
                       .off_axis = 0.4 * uniform(random),
                       .head_speed = 3 * uniform(random),
                       .hidden = hidden};
      sight.seen = uniform(random) < model.probability(fit::features_of(sight));
      found.sights.push_back(sight);
    }
  }
  return found;
}

fit::Looks planted_looks(const PlantedLooks& planted, std::uint64_t seed) {
  std::mt19937_64 random(seed);
  std::normal_distribution<double> normal;
  std::uniform_real_distribution<double> uniform;
  fit::Looks found{.recordings = {"planted"}};
  const auto images = static_cast<int>(30 * planted.seconds);
  double distance = 2, bearing = 0;
  for (int i = 0; i < images; ++i) {
    if (i % 90 == 0) distance = 0.5 + 4 * uniform(random), bearing = 3 * uniform(random) - 1.5;
    const double axis = 1.5 * std::sin(i / 60.), off = std::abs(std::remainder(bearing - axis, 2 * M_PI));
    fit::Look look{.at = i / 30.,
                   .duration = 1 / 30.,
                   .distance = distance,
                   .bearing = bearing + planted.heading_error * normal(random),
                   .height = kHeight,
                   .placed = 0.02,
                   .walking = true,
                   .across = kWidth / 2 - off,
                   .upright = std::min(std::atan2(kHeight, distance) - kUpper, 0.6),
                   .axis = axis,
                   .width = kWidth,
                   .nearest = kHeight / std::tan(kLower),
                   .farthest = kHeight / std::tan(kUpper)};
    if (std::min(look.across, look.upright) > 0 && uniform(random) < 0.9) {
      const double slope = std::max(0.035, std::atan2(kHeight, distance) + planted.noise * normal(random));
      const double range = kHeight / std::tan(slope), side = bearing + planted.noise * normal(random);
      look.has_ball = true, look.seen_x = range * std::cos(side), look.seen_y = range * std::sin(side);
    } else if (i % 10 == 0) {
      draw_false_ball(planted, random, look);
    }
    if (planted.mirrored) look.bearing = -look.bearing, look.axis = -look.axis, look.seen_y = -look.seen_y;
    found.looks.push_back(look);
  }
  return found;
}

}  // namespace robot::tests
