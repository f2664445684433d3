// The view of one sensor at one moment: robots and ball, on the field.
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <optional>
#include <vector>

namespace robot::truth {

/// A place on the ground [m, field] with its error. The covariance contains the noise of the measurement, not the error of
/// the sensor's pose, which all of its measurements share.
struct Place {
  Eigen::Vector2d position = Eigen::Vector2d::Zero();        // [m]
  Eigen::Matrix2d covariance = Eigen::Matrix2d::Identity();  // [m²]
};

struct SeenRobot {
  Place place;                                // the middle between the feet
  double height = 0;                          // [m] of its highest point; a lying robot is low
  std::optional<double> heading;              // [rad, field] only a printed tag shows it
  std::optional<double> heading_deviation;    // [rad]
  std::optional<std::uint32_t> team, player;  // likewise
};

struct SeenBall {
  Place place;  // below its centre
};

struct Detections {
  std::uint64_t capture_ns = 0;   // of the image
  std::uint64_t detected_ns = 0;  // the same clock, after detection
  std::vector<SeenRobot> robots;  // in no particular order
  std::optional<SeenBall> ball;   // the most likely one
};

}  // namespace robot::truth
