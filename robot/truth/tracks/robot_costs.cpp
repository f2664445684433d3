#include "robot/truth/tracks/robot_costs.h"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <numbers>

#include "robot/truth/tracks/gates.h"
#include "robot/truth/tracks/identity.h"
#include "robot/truth/tracks/times.h"

namespace robot::truth {
namespace {

constexpr double kDetectorError = 0.05;  // [m] a sensor that disagrees this much still means the same robot
constexpr double kNewCost = 7.8;         // false and new robots: 0.0004 for each m² and image
constexpr double kTagGain = 10;
constexpr double kHiddenAfter = 0.1;   // [s]
constexpr double kHiddenImages = 2.5;  // images

}  // namespace

double place_cost(const Place& expected, const Place& seen) {
  const Eigen::Vector2d apart = seen.position - expected.position;
  const Eigen::Matrix2d covariance =
      expected.covariance + seen.covariance + kDetectorError * kDetectorError * Eigen::Matrix2d::Identity();
  const double distance = apart.dot(covariance.inverse() * apart);
  if (distance > kGate) return kImpossible;
  return 0.5 * distance + 0.5 * std::log(covariance.determinant()) + std::log(2 * std::numbers::pi) - kNewCost;
}

double identity_cost(const TrackScene& scene, const RobotTrack& robot, const SeenRobot& seen, const OwnPoses& poses) {
  const std::optional<std::size_t> player = player_of(scene, robot);
  if (!player) return 0;
  if (const auto tag = tagged_player(seen, poses)) return *tag == *player ? -kTagGain : kImpossible;
  if (!hidden(scene, robot)) return 0;

  // a robot that comes back far from its own pose is likely another one; the opposite proves little
  const OwnPose* pose = poses.players()[*player].at(scene.now_ns);
  return pose ? std::max(0., -evidence_of(*pose, seen.place.position, seen.place.covariance)) : 0;
}

std::optional<std::size_t> tagged_player(const SeenRobot& seen, const OwnPoses& poses) {
  return seen.team && seen.player ? poses.find(*seen.team, *seen.player) : std::nullopt;
}

bool hidden(const TrackScene& scene, const RobotTrack& robot) {
  const double unseen = seconds_between(robot.sightings.newest_ns, scene.now_ns);
  return robot.sightings.track != 0 && unseen > std::max(kHiddenAfter, kHiddenImages * scene.interval);
}

}  // namespace robot::truth
