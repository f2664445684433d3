#include "robot/truth/tracks/identity.h"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <numbers>

#include "robot/truth/tracks/times.h"

namespace robot::truth {
namespace {

constexpr double kFieldArea = 54;        // [m²] where a robot may be that is nowhere here
constexpr double kWrongPose = 0.05;      // part of own poses that are far off
constexpr double kLeastDeviation = 0.1;  // [m] robots are too sure of themselves
constexpr double kIndependent = 2;       // [s] after which the error of an own pose is another one
constexpr double kSeenRecently = 0.3;    // [s]

constexpr double kBinding = 6;         // lead that binds a player
constexpr double kMostEvidence = 100;  // after that, own poses may be wrong for 30 s
constexpr double kLeastEvidence = -8;  // after that, 6 s of right own poses bind
constexpr double kMostAfterOcclusion = 3;

/// Lets the pose count for all robots in view.
void weigh(TrackScene& scene, std::size_t player, const OwnPose& pose, double weight) {
  double most = 0;
  for (RobotTrack& robot : scene.robots) {
    double& evidence = robot.evidence[player];
    if (robot.sightings.track != 0 && seconds_between(robot.sightings.newest_ns, scene.now_ns) <= kSeenRecently) {
      const double later = seconds_between(scene.now_ns, pose.capture_ns);
      const Eigen::Vector2d then = robot.estimate.position() + later * robot.estimate.velocity();
      evidence += weight * evidence_of(pose, then, robot.estimate.position_covariance());
    }
    most = std::max(most, evidence);
  }
  const double excess = std::max(0., most - kMostEvidence);
  for (RobotTrack& robot : scene.robots)
    robot.evidence[player] = std::max(kLeastEvidence, robot.evidence[player] - excess);
}

/// Returns the lead of the robot over all others and over "nowhere here".
double lead_of(const TrackScene& scene, std::size_t player, const RobotTrack& robot) {
  double rival = 0;
  for (const RobotTrack& other : scene.robots)
    if (&other != &robot) rival = std::max(rival, other.evidence[player]);
  return robot.evidence[player] - rival;
}

const RobotTrack* robot_with(const TrackScene& scene, std::uint32_t serial) {
  const auto found = std::find_if(scene.robots.begin(), scene.robots.end(),
                                  [&](const RobotTrack& robot) { return robot.sightings.serial == serial; });
  return found == scene.robots.end() ? nullptr : &*found;
}

void bind_or_release(TrackScene& scene, std::size_t player) {
  std::uint32_t& bound = scene.players[player].robot;
  const RobotTrack* robot = robot_with(scene, bound);
  if (!robot || robot->evidence[player] <= 0) bound = 0;
  for (const RobotTrack& other : scene.robots)
    if (lead_of(scene, player, other) >= kBinding) bound = other.sightings.serial;
}

void release(TrackScene& scene, const RobotTrack& robot) {
  for (KnownPlayer& player : scene.players)
    if (player.robot == robot.sightings.serial) player.robot = 0;
}

/// Releases the player with less evidence where two have the same robot.
void settle_rivals(TrackScene& scene) {
  for (const RobotTrack& robot : scene.robots) {
    std::size_t best = kMostPlayers;
    for (std::size_t player = 0; player < scene.players.size(); ++player) {
      if (scene.players[player].robot != robot.sightings.serial) continue;
      if (best != kMostPlayers) {
        const bool better = robot.evidence[player] > robot.evidence[best];
        scene.players[better ? best : player].robot = 0;
        if (!better) continue;
      }
      best = player;
    }
  }
}

}  // namespace

double evidence_of(const OwnPose& pose, const Eigen::Vector2d& position, const Eigen::Matrix2d& covariance) {
  const double deviation = std::max(pose.deviation, kLeastDeviation);
  const Eigen::Matrix2d error = covariance + deviation * deviation * Eigen::Matrix2d::Identity();
  const Eigen::Vector2d apart = pose.position - position;
  const double density =
      std::exp(-0.5 * apart.dot(error.inverse() * apart)) / (2 * std::numbers::pi * std::sqrt(error.determinant()));
  return std::log(kWrongPose + (1 - kWrongPose) * density * kFieldArea);
}

void know_players(TrackScene& scene, const OwnPoses& poses) {
  for (std::size_t player = scene.players.size(); player < poses.players().size(); ++player)
    scene.players.push_back({poses.players()[player].team, poses.players()[player].number, 0});
}

void identify(TrackScene& scene, const OwnPoses& poses, double dt) {
  for (std::size_t player = 0; player < poses.players().size(); ++player) {
    if (const OwnPose* pose = poses.players()[player].at(scene.now_ns)) weigh(scene, player, *pose, dt / kIndependent);
    bind_or_release(scene, player);
  }
  settle_rivals(scene);
}

void identify_by_tag(TrackScene& scene, std::size_t player, RobotTrack& robot) {
  for (RobotTrack& other : scene.robots) other.evidence[player] = kLeastEvidence;
  robot.evidence.fill(kLeastEvidence);
  robot.evidence[player] = kMostEvidence;
  scene.players[player].robot = robot.sightings.serial;
}

void doubt(TrackScene& scene, RobotTrack& robot) {
  release(scene, robot);
  for (double& evidence : robot.evidence) evidence = std::min(evidence, kMostAfterOcclusion);
}

void confuse(TrackScene& scene, RobotTrack& one, RobotTrack& other) {
  doubt(scene, one);
  doubt(scene, other);
  for (std::size_t player = 0; player < kMostPlayers; ++player)
    one.evidence[player] = other.evidence[player] = std::max(one.evidence[player], other.evidence[player]);
}

std::optional<std::size_t> player_of(const TrackScene& scene, const RobotTrack& robot) {
  const auto found = std::find_if(scene.players.begin(), scene.players.end(),
                                  [&](const KnownPlayer& player) { return player.robot == robot.sightings.serial; });
  if (found == scene.players.end()) return std::nullopt;
  return static_cast<std::size_t>(found - scene.players.begin());
}

}  // namespace robot::truth
