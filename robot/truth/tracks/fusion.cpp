#include "robot/truth/tracks/fusion.h"

#include <algorithm>

#include "robot/truth/tracks/ball_fusion.h"
#include "robot/truth/tracks/gates.h"
#include "robot/truth/tracks/identity.h"
#include "robot/truth/tracks/motion.h"
#include "robot/truth/tracks/posture.h"
#include "robot/truth/tracks/robot_costs.h"
#include "robot/truth/tracks/times.h"

namespace robot::truth {
namespace {

constexpr double kOneRobot = 0.2;       // [m] two robots cannot be so close; a robot split in two is one
constexpr double kDoubted = 0.5;        // [s] unseen: it may be another one
constexpr double kLongestInterval = 1;  // [s] between images; a longer one is a gap
constexpr double kLongestStep = 0.2;    // [s] for which one own pose counts

void see_tag(TrackScene& scene, RobotTrack& robot, const SeenRobot& seen, const OwnPoses& poses) {
  if (seen.heading) {
    robot.heading = seen.heading;
    robot.heading_deviation = seen.heading_deviation;
    robot.heading_ns = scene.now_ns;
  }
  if (const auto player = tagged_player(seen, poses)) identify_by_tag(scene, *player, robot);
}

/// Compares a robot that comes back with all others that are hidden.
void doubt_identity(TrackScene& scene, RobotTrack& robot, const Measurement& measurement) {
  if (!hidden(scene, robot)) return;
  const bool long_unseen = seconds_between(robot.sightings.newest_ns, scene.now_ns) > kDoubted;
  for (RobotTrack& other : scene.robots) {
    if (&other == &robot || !hidden(scene, other)) continue;
    const Place expected = expected_place(other.estimate, measurement.sensor);
    if (place_cost(expected, measurement.place) < kImpossible) confuse(scene, robot, other);
    if (long_unseen) doubt(scene, robot);
  }
}

void see_again(TrackScene& scene, const std::vector<Sensor>& sensors, RobotTrack& robot, const SeenRobot& seen,
               std::size_t sensor, const OwnPoses& poses) {
  const Measurement measurement{sensor, seen.place};
  doubt_identity(scene, robot, measurement);
  correct(robot.estimate, measurement, kGate);
  robot.sightings.see(measurement, robot_errors(sensors, robot.estimate.position()), robot.estimate.velocity(),
                      scene.now_ns);
  if (robot.sightings.track == 0 && robot.sightings.proved()) robot.sightings.track = ++scene.robots_born;
  robot.posture = judged(robot.posture, seen.height);
  see_tag(scene, robot, seen, poses);
}

/// Reports whether the image has shown the robot already.
bool seen_in(const SensorImage& image, const RobotTrack& robot) {
  return robot.sightings.seen_ns[image.sensor] == image.detections.capture_ns;
}

bool beside_a_seen_robot(const TrackScene& scene, const SensorImage& image, const Eigen::Vector2d& place) {
  return std::any_of(scene.robots.begin(), scene.robots.end(), [&](const RobotTrack& robot) {
    return seen_in(image, robot) && (robot.estimate.position() - place).norm() < kOneRobot;
  });
}

void move_robots(TrackScene& scene, double dt) {
  for (RobotTrack& robot : scene.robots)
    robot.estimate = predicted(robot.estimate, robot_step(robot.sightings.shared, dt));
}

void forget_lost_robots(TrackScene& scene) {
  const auto lost = [&](const RobotTrack& robot) { return robot.sightings.lost(scene.now_ns); };
  scene.robots.erase(std::remove_if(scene.robots.begin(), scene.robots.end(), lost), scene.robots.end());
}

}  // namespace

void Fusion::fill_costs(const TrackScene& scene, const SensorImage& image, const OwnPoses& poses) {
  const std::vector<SeenRobot>& seen = image.detections.robots;
  costs_.reset(candidates_.size(), seen.size() + candidates_.size());
  for (std::size_t row = 0; row < candidates_.size(); ++row) {
    const RobotTrack& robot = scene.robots[candidates_[row]];
    const Place expected = expected_place(robot.estimate, image.sensor);
    for (std::size_t i = 0; i < seen.size(); ++i) {
      double& cost = costs_.at(row, i);
      cost = taken_[i] ? kImpossible : place_cost(expected, seen[i].place);
      if (cost < kImpossible) cost += identity_cost(scene, robot, seen[i], poses);
    }
    // a column for each robot that is not seen
    for (std::size_t other = 0; other < candidates_.size(); ++other)
      costs_.at(row, seen.size() + other) = other == row ? kMissCost : kImpossible;
  }
}

Fusion::Rank Fusion::rank_of(const TrackScene& scene, const RobotTrack& robot) {
  if (robot.sightings.track == 0) return Rank::unconfirmed;
  return hidden(scene, robot) ? Rank::hidden : Rank::in_view;
}

/// Takes the detections that are parts of robots that were seen.
void Fusion::leave_out_seen(const TrackScene& scene, const SensorImage& image) {
  for (std::size_t i = 0; i < taken_.size(); ++i)
    if (beside_a_seen_robot(scene, image, image.detections.robots[i].place.position)) taken_[i] = 1;
}

void Fusion::match(TrackScene& scene, const SensorImage& image, const OwnPoses& poses, Rank rank) {
  candidates_.clear();
  for (std::size_t i = 0; i < scene.robots.size(); ++i)
    if (rank_of(scene, scene.robots[i]) == rank && !seen_in(image, scene.robots[i])) candidates_.push_back(i);
  leave_out_seen(scene, image);
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

void Fusion::add_robots(TrackScene& scene, const SensorImage& image, const OwnPoses& poses) const {
  for (std::size_t i = 0; i < image.detections.robots.size() && scene.robots.size() < kMostRobots; ++i) {
    const SeenRobot& seen = image.detections.robots[i];
    if (taken_[i]) continue;
    const Measurement measurement{image.sensor, seen.place};
    const SharedErrors shared = robot_errors(sensors_, seen.place.position);
    RobotTrack robot{.sightings = Sightings::begun(++scene.serials, measurement, shared, scene.now_ns),
                     .estimate = first_estimate(measurement, shared, kRobotSpeed)};
    robot.posture = judged({}, seen.height);
    scene.robots.push_back(robot);
    see_tag(scene, scene.robots.back(), seen, poses);
  }
}

void Fusion::advance(TrackScene& scene, const SensorImage& image, OwnPoses& poses) {
  const double dt = scene.now_ns == 0 ? 0 : seconds_between(scene.now_ns, image.detections.capture_ns);
  scene.now_ns = image.detections.capture_ns;
  std::uint64_t& newest_ns = scene.image_ns[image.sensor];
  scene.interval = newest_ns == 0 ? 0 : std::min(seconds_between(newest_ns, scene.now_ns), kLongestInterval);
  newest_ns = scene.now_ns;
  scene.detected_ns[image.sensor] = image.detections.detected_ns;
  for (const SeenRobot& seen : image.detections.robots)
    if (seen.team && seen.player) (void)poses.find_or_add(*seen.team, *seen.player);
  know_players(scene, poses);

  forget_lost_robots(scene);
  move_robots(scene, dt);
  taken_.assign(image.detections.robots.size(), 0);
  // robots in view come first: a hidden one must not take what belongs to them
  for (const Rank rank : {Rank::in_view, Rank::hidden, Rank::unconfirmed}) match(scene, image, poses, rank);
  leave_out_seen(scene, image);
  add_robots(scene, image, poses);
  forget_lost_robots(scene);

  advance_ball(scene, sensors_, image);
  identify(scene, poses, std::min(dt, kLongestStep));
}

}  // namespace robot::truth
