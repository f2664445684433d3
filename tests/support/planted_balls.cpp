#include "tests/support/planted_balls.h"

#include <algorithm>
#include <cmath>
#include <random>

namespace robot::tests {

fit::BallSizes planted_balls(const PlantedBalls& planted, std::uint64_t seed) {
  std::mt19937_64 random(seed);
  std::normal_distribution<double> normal;
  std::uniform_real_distribution<double> uniform;
  fit::BallSizes seen;
  seen.recordings = {"planted"};
  seen.clock_deviation = {0};
  for (std::size_t pass = 0; pass < planted.passes; ++pass) {
    // the robot walks to the ball or from it, so that a pass covers a way
    const double rate = uniform(random) < 0.5 ? 0.2 : -0.2;
    double distance = planted.nearest * std::pow(planted.farthest / planted.nearest, uniform(random));
    for (std::size_t i = 0; i < planted.images; ++i) {
      distance = std::clamp(distance + rate / 30, planted.nearest, planted.farthest);
      double radius = planted.offset + planted.scale / std::hypot(distance, planted.height);
      radius += normal(random) * (planted.radius_error + planted.radius_share * radius);
      if (uniform(random) < planted.occluded) radius *= 0.5 + 0.4 * uniform(random);
      const double believed = distance * (1 + 0.1 * normal(random));
      seen.sizes.push_back({.recording = 0,
                            .at = 3 * static_cast<double>(pass) + static_cast<double>(i) / 30,
                            .radius = std::max(1., std::round(radius)),
                            .distance = distance + planted.truth_error * normal(random) + planted.late * rate,
                            .deviation = planted.truth_error,
                            .rate = rate,
                            .believed = believed});
    }
  }
  return seen;
}

}  // namespace robot::tests
