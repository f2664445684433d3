// Sensors that place one thing differently, beyond their errors.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>

#include "robot/truth/tracks/estimate.h"

namespace robot::truth {

/// The comparison of the sensors that see one thing. Bounded memory.
class Disagreement {
 public:
  struct Finding {
    std::size_t first = 0, second = 0;  // indices of the sensors
    double apart = 0, expected = 0;     // [m]
  };

  /// Compares a measurement with the newest ones of the other sensors. `velocity` is the thing's [m/s].
  void compare(const Measurement& measurement, const Eigen::Matrix2d& shared, const Eigen::Vector2d& velocity,
               std::uint64_t capture_ns);

  /// Returns the two sensors that disagree most, if any do with 99.9 % confidence: over the last ten or more comparisons,
  /// both within the last half second.
  std::optional<Finding> worst(std::uint64_t now_ns) const;

 private:
  struct Newest {
    std::uint64_t capture_ns = 0;  // 0: none yet
    Place place;
    Eigen::Matrix2d shared = Eigen::Matrix2d::Zero();  // [m²]
  };
  struct Pair {
    Eigen::Vector2d apart = Eigen::Vector2d::Zero();   // [m] running mean
    Eigen::Matrix2d noise = Eigen::Matrix2d::Zero();   // [m²] of one comparison
    Eigen::Matrix2d shared = Eigen::Matrix2d::Zero();  // [m²] of all of them
    int count = 0;
    std::uint64_t newest_ns = 0;
  };

  static std::size_t pair_of(std::size_t first, std::size_t second) { return second * (second - 1) / 2 + first; }

  std::array<Newest, kMostSensors> newest_;
  std::array<Pair, kMostSensors*(kMostSensors - 1) / 2> pairs_;
};

/// Returns "sensors 1 and 2 place robot 3 at (1.20, -0.40) m 14 cm apart, expected 4 cm".
std::string sentence_of(const Disagreement::Finding& finding, const std::string& thing, const Eigen::Vector2d& place);

}  // namespace robot::truth
