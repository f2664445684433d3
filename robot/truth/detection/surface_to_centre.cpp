#include "robot/truth/detection/surface_to_centre.h"

#include <algorithm>
#include <cmath>

#include "robot/core/text.h"
#include "robot/truth/detection/detector.h"

namespace robot::truth {
namespace {

constexpr double kNear = 0.5;  // [m] of its mark

/// Returns the robot that is nearest to a mark, or nothing when none is near.
const SeenRobot* robot_on(const Eigen::Vector2d& mark, const std::vector<SeenRobot>& robots) {
  const auto distance = [&](const SeenRobot& robot) { return (robot.place.position - mark).norm(); };
  const auto nearest = std::min_element(
      robots.begin(), robots.end(), [&](const SeenRobot& a, const SeenRobot& b) { return distance(a) < distance(b); });
  return nearest != robots.end() && distance(*nearest) < kNear ? &*nearest : nullptr;
}

/// Sums for the slope of a line through the origin: an offset of `level` times the constant makes this error.
struct Slope {
  double numerator = 0, denominator = 0;

  void add(double level, double error) {
    numerator += level * error;
    denominator += level * level;
  }
};

}  // namespace

Result<double> fit_surface_to_centre(const SensorPose& pose, const sim::field::Field& field, DetectorOptions options,
                                     const std::vector<MarkedFrame>& frames) {
  options.surface_to_centre = 0;
  Result<Detector> detector = Detector::create(pose, field, options);
  if (!detector) return detector.failure();
  const Eigen::Vector3d eye = pose.field_from_sensor.translation();
  Slope slope;
  for (const MarkedFrame& marked : frames) {
    const Result<Detections> seen = detector->detect(marked.frame);
    if (!seen) return seen.failure();
    const SeenRobot* const robot = robot_on(marked.mark, seen->robots);
    if (robot == nullptr) continue;
    const Eigen::Vector2d away = marked.mark - eye.head<2>();
    const double level = away.norm() / std::hypot(away.norm(), eye.z() - options.robot_height);
    slope.add(level, (marked.mark - robot->place.position).dot(away.normalized()));
  }
  if (slope.denominator == 0)
    return Error{
        formatted("distance from surface to centre: expected images of a robot within %g m of its mark, got %zu "
                  "without one",
                  kNear, frames.size())};
  return slope.numerator / slope.denominator;
}

}  // namespace robot::truth
