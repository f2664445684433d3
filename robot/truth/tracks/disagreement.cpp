#include "robot/truth/tracks/disagreement.h"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>

#include "robot/core/text.h"
#include "robot/truth/tracks/times.h"

namespace robot::truth {
namespace {

constexpr double kComparable = 0.1;  // [s] between two measurements
constexpr int kLeastComparisons = 10;
constexpr int kMostComparisons = 20;  // that the running mean is worth
constexpr double kFresh = 0.5;        // [s]
constexpr double kOwnError = 0.02;    // [m] of a detector: a robot's middle seen from another side
constexpr double kConfident = 13.8;   // 99.9 % of two squared deviations

}  // namespace

void Disagreement::compare(const Measurement& measurement, const Eigen::Matrix2d& shared,
                           const Eigen::Vector2d& velocity, std::uint64_t capture_ns) {
  newest_[measurement.sensor] = {capture_ns, measurement.place, shared};
  for (std::size_t other = 0; other < kMostSensors; ++other) {
    const double dt = seconds_between(newest_[other].capture_ns, capture_ns);
    if (other == measurement.sensor || dt > kComparable) continue;

    Eigen::Vector2d apart = measurement.place.position - newest_[other].place.position - dt * velocity;
    if (other > measurement.sensor) apart = -apart;
    Pair& pair = pairs_[pair_of(std::min(other, measurement.sensor), std::max(other, measurement.sensor))];
    pair.count = std::min(pair.count + 1, kMostComparisons);
    pair.apart += (apart - pair.apart) / pair.count;
    pair.noise = measurement.place.covariance + newest_[other].place.covariance;
    pair.shared = shared + newest_[other].shared;
    pair.newest_ns = capture_ns;
  }
}

std::optional<Disagreement::Finding> Disagreement::worst(std::uint64_t now_ns) const {
  std::optional<Finding> found;
  double largest = kConfident;
  for (std::size_t second = 1; second < kMostSensors; ++second)
    for (std::size_t first = 0; first < second; ++first) {
      const Pair& pair = pairs_[pair_of(first, second)];
      if (pair.count < kLeastComparisons || seconds_between(pair.newest_ns, now_ns) > kFresh) continue;
      const Eigen::Matrix2d expected =
          pair.shared + pair.noise / pair.count + 2 * kOwnError * kOwnError * Eigen::Matrix2d::Identity();
      const double distance = pair.apart.dot(expected.inverse() * pair.apart);
      if (distance <= largest) continue;
      largest = distance;
      found = Finding{first, second, pair.apart.norm(), std::sqrt(expected.trace())};
    }
  return found;
}

std::string sentence_of(const Disagreement::Finding& finding, const std::string& thing, const Eigen::Vector2d& place) {
  return formatted("sensors %zu and %zu place %s at (%.2f, %.2f) m %.0f cm apart, expected %.0f cm", finding.first + 1,
                   finding.second + 1, thing.c_str(), place.x(), place.y(), 100 * finding.apart,
                   100 * finding.expected);
}

}  // namespace robot::truth
