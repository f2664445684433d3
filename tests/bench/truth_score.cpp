#include "tests/bench/truth_score.h"

#include <algorithm>
#include <numbers>

#include "sim/statistics/sample.h"

namespace bench {

using namespace robot::truth;
using sim::statistics::mean_of;
using sim::statistics::quantile;
using sim::statistics::ratio;

namespace {

bool within_5_m(const SensorPose& pose, double x, double y) {
  constexpr double kMiddle = 0.4;  // [m] height
  return (Eigen::Vector3d(x, y, kMiddle) - pose.field_from_sensor.translation()).norm() < 5;
}

}  // namespace

void TruthTally::add(const Place& place, const Eigen::Vector2d& truth, bool near) {
  const Eigen::Vector2d error = place.position - truth;
  ++found;
  if (near) errors.push_back(error.norm());
  squares.push_back(error.dot(place.covariance.inverse() * error));
}

nlohmann::json TruthTally::figures(int frames) const {
  return {{"recall", ratio(found, there)},
          {"false_per_frame", ratio(wrong, frames)},
          {"mean_cm", 100 * mean_of(errors)},
          {"p95_cm", 100 * quantile(errors, 0.95)},
          {"normalised_error_squared", mean_of(squares)}};
}

void TruthScore::add_robots(const Scene& scene, const SensorPose& pose, std::vector<SeenRobot> seen) {
  constexpr double kSame = 0.3;  // [m]
  for (const SceneRobot& robot : scene.robots) {
    TruthTally& tally = robot.fallen ? lying : standing;
    const Eigen::Vector2d truth(robot.x, robot.y);
    const auto distance = [&](const SeenRobot& each) { return (each.place.position - truth).norm(); };
    const auto nearest = std::min_element(
        seen.begin(), seen.end(), [&](const SeenRobot& a, const SeenRobot& b) { return distance(a) < distance(b); });
    ++tally.there;
    if (nearest == seen.end() || distance(*nearest) > kSame) continue;
    tally.add(nearest->place, truth, within_5_m(pose, robot.x, robot.y));
    seen.erase(nearest);
  }
  standing.wrong += static_cast<int>(seen.size());
}

void TruthScore::add_ball(const SceneBall& truth, bool visible, const SensorPose& pose,
                          const std::optional<SeenBall>& seen) {
  constexpr double kSame = 0.15;  // [m]
  const Eigen::Vector2d place(truth.x, truth.y);
  const bool right = seen && (seen->place.position - place).norm() < kSame;
  ball.wrong += seen && !right;
  ball.there += visible;
  if (visible && right) ball.add(seen->place, place, within_5_m(pose, truth.x, truth.y));
}

nlohmann::json TruthScore::figures(int frames) const {
  return {{"frames", frames},
          {"median_ms", quantile(milliseconds, 0.5)},
          {"p95_ms", quantile(milliseconds, 0.95)},
          {"robots", standing.figures(frames)},
          {"lying_robots", lying.figures(frames)},
          {"ball", ball.figures(frames)}};
}

bool visible(const Renderer& renderer, const SceneBall& ball) {
  const SensorPose& pose = renderer.pose();
  const auto& materials = renderer.cast().material;
  const auto shown = std::count_if(materials.begin(), materials.end(), [](Material material) {
    return material == Material::orange || material == Material::white || material == Material::black;
  });
  const double z = (pose.field_from_sensor.inverse() * Eigen::Vector3d(ball.x, ball.y, ball.z)).z();
  const double radius = pose.intrinsics.focal_x * ball.radius / z;
  return static_cast<double>(shown) > 0.7 * std::numbers::pi * radius * radius;
}

}  // namespace bench
