#include "robot/truth/tracks/usable.h"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <tuple>

#include "robot/core/text.h"

namespace robot::truth {
namespace {

constexpr double kFarthest = 100;         // [m]
constexpr double kLeastVariance = 1e-10;  // [m²]
constexpr double kMostVariance = 100;     // [m²]
constexpr double kLeastRoundness = 1e-6;  // an ellipse 1000 times as long as wide is no measurement
constexpr double kRounding = 1e-6;        // asymmetry that comes from rounding, relative

bool is_covariance(const Eigen::Matrix2d& covariance) {
  return covariance.allFinite() && covariance.diagonal().minCoeff() >= kLeastVariance &&
         covariance.diagonal().maxCoeff() <= kMostVariance &&
         std::abs(covariance(0, 1) - covariance(1, 0)) <= kRounding * covariance.trace() &&
         covariance.determinant() > kLeastRoundness * covariance(0, 0) * covariance(1, 1);
}

bool is_usable(const Place& place) {
  return place.position.allFinite() && place.position.cwiseAbs().maxCoeff() <= kFarthest &&
         is_covariance(place.covariance);
}

/// Returns the place with a covariance that is symmetric to the bit, as the filters need it.
Place symmetric(const Place& place) {
  return {.position = place.position, .covariance = 0.5 * (place.covariance + place.covariance.transpose())};
}

SeenRobot cleaned(SeenRobot robot) {
  robot.place = symmetric(robot.place);
  const bool finite =
      robot.heading && std::isfinite(*robot.heading) && std::isfinite(robot.heading_deviation.value_or(0));
  if (!finite) {
    robot.heading.reset();
    robot.heading_deviation.reset();
  }
  return robot;
}

}  // namespace

Result<void> check_image(const SensorImage& image, std::size_t sensors) {
  if (image.sensor >= sensors)
    return Error{formatted("image of sensor %zu: expected a sensor from 1 to %zu", image.sensor + 1, sensors)};
  if (image.detections.capture_ns == 0)
    return Error{formatted("sensor %zu: an image has no capture time", image.sensor + 1)};
  return {};
}

Detections usable(const Detections& detections, std::uint64_t& refused) {
  Detections result{.capture_ns = detections.capture_ns, .detected_ns = detections.detected_ns};
  for (const SeenRobot& robot : detections.robots)
    if (is_usable(robot.place)) result.robots.push_back(cleaned(robot));
  std::sort(result.robots.begin(), result.robots.end(), [](const SeenRobot& a, const SeenRobot& b) {
    const auto key = [](const SeenRobot& robot) {
      return std::tuple(robot.place.position.x(), robot.place.position.y(), robot.place.covariance(0, 0));
    };
    return key(a) < key(b);
  });
  if (result.robots.size() > kMostSeenRobots) result.robots.resize(kMostSeenRobots);
  if (detections.ball && is_usable(detections.ball->place))
    result.ball = SeenBall{.place = symmetric(detections.ball->place)};
  refused += detections.robots.size() - result.robots.size() + (detections.ball && !result.ball);
  return result;
}

}  // namespace robot::truth
