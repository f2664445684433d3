#include "robot/truth/tracks/scene.h"

#include <algorithm>

#include "robot/core/text.h"
#include "robot/truth/tracks/motion.h"
#include "robot/truth/tracks/times.h"

namespace robot::truth {
namespace {

constexpr double kNewImage = 0.1;    // [s]
constexpr double kNewHeading = 0.1;  // [s]

bool shown_by(const TrackScene& scene, const Sightings& sightings, std::size_t sensor) {
  return sightings.seen_ns[sensor] != 0 && sightings.seen_ns[sensor] == scene.image_ns[sensor] &&
         seconds_between(scene.image_ns[sensor], scene.now_ns) <= kNewImage;
}

std::uint32_t sensors_of(const TrackScene& scene, const Sightings& sightings) {
  std::uint32_t count = 0;
  for (std::size_t sensor = 0; sensor < kMostSensors; ++sensor) count += shown_by(scene, sightings, sensor);
  return count;
}

FusedPlace place_in(const TrackScene& scene, const Sightings& sightings, const Estimate& estimate) {
  return place_of(estimate, sightings.track, sensors_of(scene, sightings));
}

void add_disagreement(FusedTruth& truth, const Sightings& sightings, const std::string& thing,
                      const Eigen::Vector2d& place) {
  if (const auto finding = sightings.disagreement.worst(truth.capture_ns))
    truth.disagreements.push_back(sentence_of(*finding, thing, place));
}

}  // namespace

TrackScene restarted(const TrackScene& scene) {
  TrackScene empty;
  empty.serials = scene.serials;
  empty.robots_born = scene.robots_born;
  empty.balls_born = scene.balls_born;
  return empty;
}

FusedPlace place_of(const Estimate& estimate, std::uint32_t track, std::uint32_t sensors) {
  return {.track = track,
          .position = estimate.position(),
          .velocity = estimate.velocity(),
          .covariance = estimate.position_covariance(),
          .velocity_covariance = estimate.velocity_covariance(),
          .sensors = sensors};
}

bool visible(const TrackScene& scene, const Sightings& sightings) { return sensors_of(scene, sightings) > 0; }

FusedRobot report_of(const TrackScene& scene, const RobotTrack& robot) {
  FusedRobot report{.place = place_in(scene, robot.sightings, robot.estimate)};
  for (const KnownPlayer& player : scene.players)
    if (player.robot == robot.sightings.serial) {
      report.team = player.team;
      report.player = player.number;
    }
  if (robot.heading && seconds_between(robot.heading_ns, scene.now_ns) <= kNewHeading) {
    report.heading = robot.heading;
    report.heading_deviation = robot.heading_deviation;
  }
  if (robot.posture.height > 0) report.fallen = robot.posture.fallen;
  return report;
}

FusedBall report_of(const TrackScene& scene, const BallTrack& ball) {
  const Estimate newest = ball.paths.mixture();
  const double dt = seconds_between(ball.paths_ns, scene.now_ns);
  return {place_in(scene, ball.sightings, predicted(newest, ball_step(newest, ball.sightings.shared, dt)))};
}

FusedTruth truth_of(const TrackScene& scene) {
  FusedTruth truth{.capture_ns = scene.now_ns};
  for (std::size_t sensor = 0; sensor < kMostSensors; ++sensor)
    if (seconds_between(scene.image_ns[sensor], scene.now_ns) <= kNewImage)
      truth.detected_ns = std::max(truth.detected_ns, scene.detected_ns[sensor]);

  if (scene.ball && visible(scene, scene.ball->sightings)) {
    truth.ball = report_of(scene, *scene.ball);
    add_disagreement(truth, scene.ball->sightings, "the ball", truth.ball->place.position);
  }
  for (const RobotTrack& robot : scene.robots) {
    if (robot.sightings.track == 0 || !visible(scene, robot.sightings)) continue;
    truth.robots.push_back(report_of(scene, robot));
    add_disagreement(truth, robot.sightings, formatted("robot %u", robot.sightings.track), robot.estimate.position());
  }
  std::sort(truth.robots.begin(), truth.robots.end(),
            [](const FusedRobot& a, const FusedRobot& b) { return a.place.track < b.place.track; });
  return truth;
}

}  // namespace robot::truth
