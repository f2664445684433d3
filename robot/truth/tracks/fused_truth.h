// The truth that all sensors together report.
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace robot::truth {

/// Place and velocity on the ground. The covariances contain the errors of the sensors' poses.
struct FusedPlace {
  std::uint32_t track = 0;                                            // from 1; the same thing keeps its number
  Eigen::Vector2d position = Eigen::Vector2d::Zero();                 // [m, field]
  Eigen::Vector2d velocity = Eigen::Vector2d::Zero();                 // [m/s]
  Eigen::Matrix2d covariance = Eigen::Matrix2d::Identity();           // [m²] of the position
  Eigen::Matrix2d velocity_covariance = Eigen::Matrix2d::Identity();  // [m²/s²]
  std::uint32_t sensors = 0;  // count of those that saw it in their newest image
};

/// The ball. Its track is new after the ball was lost.
struct FusedBall {
  FusedPlace place;
};

/// One robot. Its track stays the same through an occlusion of some seconds.
struct FusedRobot {
  FusedPlace place;
  std::optional<std::uint32_t> team, player;         // absent: not identified
  std::optional<double> heading, heading_deviation;  // [rad, field] absent: no tag was seen
  std::optional<bool> fallen;                        // absent: its height was not measured
};

/// The field at one moment. A thing that was not seen is missing, not repeated.
struct FusedTruth {
  std::uint64_t capture_ns = 0;   // of the newest image
  std::uint64_t detected_ns = 0;  // the latest end of detection of the images it came from
  std::optional<FusedBall> ball;
  std::vector<FusedRobot> robots;          // in the order of their tracks
  std::vector<std::string> disagreements;  // one sentence for each thing that two sensors place differently
};

}  // namespace robot::truth
