// The study of the thesis: 460 images of a ball.
#include <algorithm>
#include <cmath>
#include <iostream>
#include <nlohmann/json.hpp>
#include <random>
#include <utility>
#include <vector>

#include "robot/core/clock.h"
#include "robot/fit/ball_distance/ball_distance.h"
#include "sim/statistics/sample.h"
#include "tests/bench/fit/planted.h"
#include "tests/support/planted_balls.h"

namespace bench {
namespace {

using nlohmann::json;
using robot::fit::BallSize, robot::fit::Curve, robot::fit::CurveKind;
using robot::tests::planted_balls, robot::tests::PlantedBalls;

double mean_error(const Curve& curve, const std::vector<BallSize>& sizes) {
  double sum = 0;
  for (const BallSize& size : sizes) sum += std::abs(curve.distance(size.radius) - size.distance);
  return sum / static_cast<double>(sizes.size());
}

}  // namespace

void study(int repetitions) {
  constexpr std::pair<double, double> kRanges[] = {{0.5, 3}, {0.15, 0.5}, {3, 4.5}};
  std::vector<double> errors[3][3], seconds;
  for (int i = 0; i < repetitions; ++i) {
    const auto seed = static_cast<std::uint64_t>(i);
    const auto trained = planted_balls({.truth_error = kTruthError}, seed).sizes;
    const robot::fit::Group all = robot::fit::all_of(trained.size());
    const CurveKind kinds[] = {CurveKind::pinhole, CurveKind::power_law, CurveKind::constant};
    for (std::size_t range = 0; range < 3; ++range) {
      // the truth of the test is exact, so that its error is not counted
      const auto [nearest, farthest] = kRanges[range];
      const auto other =
          planted_balls({.nearest = nearest, .farthest = farthest, .truth_error = 0, .passes = 60}, 1'000'000 + seed);
      for (std::size_t kind = 0; kind < 3; ++kind)
        errors[kind][range].push_back(mean_error(robot::fit::fit_curve(kinds[kind], trained, all), other.sizes));
    }
    const std::uint64_t start_ns = robot::thread_cpu_ns();
    if (robot::fit::fit_ball_distance(planted_balls({.truth_error = kTruthError}, seed)))
      seconds.push_back(static_cast<double>(robot::thread_cpu_ns() - start_ns) * 1e-9);
  }
  json line{{"case", "study"}, {"images", 460}, {"seconds", sim::statistics::median(seconds)}};
  const char* names[] = {"pinhole", "power_law", "constant"};
  const char* ranges[] = {"in_range_cm", "near_cm", "far_cm"};
  for (std::size_t kind = 0; kind < 3; ++kind)
    for (std::size_t range = 0; range < 3; ++range)
      line[names[kind]][ranges[range]] = 100 * sim::statistics::mean_of(errors[kind][range]);
  std::cout << line.dump() << '\n';
}

void ball_distance(int repetitions) {
  const PlantedBalls planted{.truth_error = kTruthError};
  Planted tallies({{"ball_distance.scale", planted.scale},
                   {"ball_distance.offset", planted.offset},
                   {"ball_distance.height", planted.height}});
  std::mt19937 random(1);
  for (int i = 0; i < repetitions; ++i) {
    PlantedBalls late = planted;
    late.late = kClockError * std::normal_distribution<double>()(random);
    auto seen = planted_balls(late, 100 + static_cast<std::uint64_t>(i));
    seen.clock_deviation = {kClockError};
    if (const auto fit = robot::fit::fit_ball_distance(std::move(seen))) tallies.add(fit->figures);
  }
  tallies.print();
}

}  // namespace bench
