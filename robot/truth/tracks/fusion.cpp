#include "robot/truth/tracks/fusion.h"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <numbers>

#include "robot/truth/tracks/ball_fusion.h"
#include "robot/truth/tracks/gates.h"
#include "robot/truth/tracks/identity.h"
#include "robot/truth/tracks/motion.h"
#include "robot/truth/tracks/posture.h"
#include "robot/truth/tracks/times.h"

namespace robot::truth {
namespace {

constexpr double kDetectorError = 0.05;  // [m] a sensor that disagrees this much still means the same robot
constexpr double kOneRobot = 0.2;        // [m] two robots cannot be so close; a robot split in two is one
constexpr double kOccluded = 0.1;        // [s] unseen: its own pose helps to find it again
constexpr double kDoubted = 0.5;         // [s] unseen: it may be another one
constexpr double kLongestStep = 0.2;     // [s] for which one own pose counts

// costs are negative logarithms of densities and probabilities
constexpr double kMissCost = 2.3;  // a robot is hidden or overlooked in one image of ten
constexpr double kNewCost = 7.8;   // false and new robots: 0.0004 for each m² and image
constexpr double kTagGain = 10;
constexpr double kImpossible = 1e6;

std::optional<std::size_t> tagged_player(const SeenRobot& seen, OwnPoses& poses) {
  return seen.team && seen.player ? poses.index_of(*seen.team, *seen.player) : std::nullopt;
}

/// Returns the cost of the place alone, or kImpossible.
double place_cost(const RobotTrack& robot, const Measurement& measurement) {
  const Innovation found = innovation(robot.estimate, measurement);
  const Eigen::Matrix2d covariance = found.covariance + kDetectorError * kDetectorError * Eigen::Matrix2d::Identity();
  const double distance = found.difference.dot(covariance.inverse() * found.difference);
  if (distance > kGate) return kImpossible;
  return 0.5 * distance + 0.5 * std::log(covariance.determinant()) + std::log(2 * std::numbers::pi) - kNewCost;
}

/// Returns the cost that tag and own pose add if the robot is the seen one.
double identity_cost(const Scene& scene, const RobotTrack& robot, const SeenRobot& seen, OwnPoses& poses) {
  const std::optional<std::size_t> player = player_of(scene, robot);
  if (!player) return 0;
  if (const auto tag = tagged_player(seen, poses)) return *tag == *player ? -kTagGain : kImpossible;
  if (seconds_between(robot.sightings.newest_ns, scene.now_ns) <= kOccluded) return 0;
  const OwnPose* pose = poses.players()[*player].at(scene.now_ns);
  return pose ? -evidence_of(*pose, seen.place.position, seen.place.covariance) : 0;
}

void see_tag(Scene& scene, RobotTrack& robot, const SeenRobot& seen, OwnPoses& poses) {
  if (seen.heading) {
    robot.heading = seen.heading;
    robot.heading_deviation = seen.heading_deviation;
    robot.heading_ns = scene.now_ns;
  }
  if (const auto player = tagged_player(seen, poses)) identify_by_tag(scene, *player, robot);
}

void see_again(Scene& scene, const std::vector<Sensor>& sensors, RobotTrack& robot, const SeenRobot& seen,
               std::size_t sensor, OwnPoses& poses) {
  const Measurement measurement{sensor, seen.place};
  if (seconds_between(robot.sightings.newest_ns, scene.now_ns) > kDoubted) doubt(robot);
  correct(robot.estimate, measurement, kGate);
  robot.sightings.shared = robot_errors(sensors, robot.estimate.position());
  robot.sightings.see(measurement, robot.estimate.velocity(), scene.now_ns);
  if (robot.sightings.track == 0 && robot.sightings.proved()) robot.sightings.track = ++scene.robots_born;
  robot.posture = judged(robot.posture, seen.height);
  see_tag(scene, robot, seen, poses);
}

bool beside_a_seen_robot(const Scene& scene, const Eigen::Vector2d& place) {
  return std::any_of(scene.robots.begin(), scene.robots.end(), [&](const RobotTrack& robot) {
    return robot.sightings.newest_ns == scene.now_ns && (robot.estimate.position() - place).norm() < kOneRobot;
  });
}

void move_robots(Scene& scene, double dt) {
  for (RobotTrack& robot : scene.robots)
    robot.estimate = predicted(robot.estimate, robot_step(robot.sightings.shared, dt));
}

void forget_lost_robots(Scene& scene) {
  const auto lost = [&](const RobotTrack& robot) { return robot.sightings.lost(scene.now_ns); };
  scene.robots.erase(std::remove_if(scene.robots.begin(), scene.robots.end(), lost), scene.robots.end());
}

}  // namespace

void Fusion::fill_costs(const Scene& scene, const SensorImage& image, OwnPoses& poses) {
  const std::vector<SeenRobot>& seen = image.detections.robots;
  costs_.reset(candidates_.size(), seen.size() + candidates_.size());
  for (std::size_t row = 0; row < candidates_.size(); ++row) {
    const RobotTrack& robot = scene.robots[candidates_[row]];
    for (std::size_t i = 0; i < seen.size(); ++i) {
      double& cost = costs_.at(row, i);
      cost = taken_[i] ? kImpossible : place_cost(robot, {image.sensor, seen[i].place});
      if (cost < kImpossible) cost += identity_cost(scene, robot, seen[i], poses);
    }
    // a column for each robot that is not seen
    for (std::size_t other = 0; other < candidates_.size(); ++other)
      costs_.at(row, seen.size() + other) = other == row ? kMissCost : kImpossible;
  }
}

void Fusion::match(Scene& scene, const SensorImage& image, OwnPoses& poses, bool confirmed) {
  candidates_.clear();
  for (std::size_t i = 0; i < scene.robots.size(); ++i)
    if ((scene.robots[i].sightings.track != 0) == confirmed && scene.robots[i].sightings.newest_ns != scene.now_ns)
      candidates_.push_back(i);
  fill_costs(scene, image, poses);

  const std::vector<std::size_t>& columns = assignment_.solve(costs_);
  for (std::size_t row = 0; row < candidates_.size(); ++row) {
    RobotTrack& robot = scene.robots[candidates_[row]];
    const std::size_t i = columns[row];
    if (i >= image.detections.robots.size()) {
      robot.sightings.miss(image.sensor);
      continue;
    }
    taken_[i] = 1;
    see_again(scene, sensors_, robot, image.detections.robots[i], image.sensor, poses);
  }
}

void Fusion::add_robots(Scene& scene, const SensorImage& image, OwnPoses& poses) const {
  for (std::size_t i = 0; i < image.detections.robots.size() && scene.robots.size() < kMostRobots; ++i) {
    const SeenRobot& seen = image.detections.robots[i];
    if (taken_[i] || beside_a_seen_robot(scene, seen.place.position)) continue;
    const Measurement measurement{image.sensor, seen.place};
    RobotTrack robot{.sightings = Sightings::begun(++scene.serials, measurement, scene.now_ns), .estimate = {}};
    robot.sightings.shared = robot_errors(sensors_, seen.place.position);
    robot.estimate = first_estimate(measurement, robot.sightings.shared, kRobotSpeed);
    robot.posture = judged({}, seen.height);
    scene.robots.push_back(robot);
    see_tag(scene, scene.robots.back(), seen, poses);
  }
}

void Fusion::advance(Scene& scene, const SensorImage& image, OwnPoses& poses) {
  const double dt = scene.now_ns == 0 ? 0 : seconds_between(scene.now_ns, image.detections.capture_ns);
  scene.now_ns = image.detections.capture_ns;
  scene.image_ns[image.sensor] = scene.now_ns;
  scene.detected_ns[image.sensor] = image.detections.detected_ns;
  know_players(scene, poses);
  for (const SeenRobot& seen : image.detections.robots)
    if (tagged_player(seen, poses)) know_players(scene, poses);

  forget_lost_robots(scene);
  move_robots(scene, dt);
  taken_.assign(image.detections.robots.size(), 0);
  match(scene, image, poses, /*confirmed=*/true);
  match(scene, image, poses, /*confirmed=*/false);
  add_robots(scene, image, poses);
  forget_lost_robots(scene);

  advance_ball(scene, sensors_, image);
  identify(scene, poses, std::min(dt, kLongestStep));
}

}  // namespace robot::truth
