#include "robot/truth/tracks/smoother.h"

#include <algorithm>
#include <map>
#include <utility>

#include "robot/core/text.h"
#include "robot/truth/tracks/identity.h"
#include "robot/truth/tracks/joining.h"
#include "robot/truth/tracks/times.h"
#include "robot/truth/tracks/usable.h"

namespace robot::truth {
namespace {

constexpr std::uint64_t kPosesAhead = 150'000'000;  // [ns] own poses that are this much later are known at an image

/// The recording while it passes: the tracker's truth of each image, and the trails of all things by their serials.
struct Passage {
  std::vector<FusedTruth> truths;
  std::map<std::uint32_t, RobotTrail> robots;
  std::map<std::uint32_t, Trail> balls;
};

Moment moment_of(const TrackScene& scene, std::size_t image, const Sightings& sightings) {
  return {.image = image, .capture_ns = scene.now_ns, .track = sightings.track, .measurement = {}};
}

void note_player(RobotTrail& trail, std::optional<std::size_t> player) {
  if (!player) return;
  trail.several_players |= trail.player && *trail.player != *player;
  trail.player = player;
}

void note_robots(Passage& passage, const TrackScene& scene, std::size_t image) {
  for (const RobotTrack& robot : scene.robots) {
    if (!visible(scene, robot.sightings)) continue;
    RobotTrail& trail = passage.robots[robot.sightings.serial];
    trail.trail.track = robot.sightings.track;
    note_player(trail, player_of(scene, robot));
    trail.trail.moments.push_back(moment_of(scene, image, robot.sightings));
    if (robot.sightings.newest_ns == scene.now_ns) trail.trail.moments.back().measurement = robot.sightings.newest;
  }
}

void note_balls(Passage& passage, const TrackScene& scene, std::size_t image) {
  for (const std::optional<BallTrack>* ball : {&scene.ball, &scene.new_ball}) {
    if (!*ball) continue;
    const bool measured = (*ball)->paths_ns == scene.now_ns;
    if (!measured && !visible(scene, (*ball)->sightings)) continue;
    Trail& trail = passage.balls[(*ball)->sightings.serial];
    trail.track = (*ball)->sightings.track;
    trail.moments.push_back(moment_of(scene, image, (*ball)->sightings));
    if (measured) trail.moments.back().measurement = (*ball)->measurement;
  }
}

Passage passage_of(Fusion& fusion, const std::vector<SensorImage>& images, const std::vector<OwnPose>& poses,
                   OwnPoses& known) {
  Passage passage;
  TrackScene scene;
  auto pose = poses.begin();
  std::uint64_t refused = 0;
  for (std::size_t i = 0; i < images.size(); ++i) {
    for (; pose != poses.end() && pose->capture_ns <= images[i].detections.capture_ns + kPosesAhead; ++pose)
      (void)known.add(*pose);
    fusion.advance(scene, {images[i].sensor, usable(images[i].detections, refused)}, known);
    passage.truths.push_back(truth_of(scene));
    note_robots(passage, scene, i);
    note_balls(passage, scene, i);
  }
  return passage;
}

/// Returns the confirmed trails of robots, those that an occlusion has broken as one.
std::vector<RobotTrail> robots_of(Passage& passage, const std::vector<Sensor>& sensors) {
  std::vector<RobotTrail> trails;
  for (auto& [serial, trail] : passage.robots)
    if (trail.trail.track != 0) trails.push_back(std::move(trail));
  join_broken(trails, sensors);
  return trails;
}

/// Returns the tracker's report of the robot at this moment; without identity while it was not confirmed.
FusedRobot report_at(const FusedTruth& truth, const Moment& moment) {
  const auto found = std::find_if(truth.robots.begin(), truth.robots.end(),
                                  [&](const FusedRobot& robot) { return robot.place.track == moment.track; });
  FusedRobot report = found == truth.robots.end() ? FusedRobot{} : *found;
  report.place.sensors = std::max(1u, report.place.sensors);
  return report;
}

bool contains(const FusedTruth& truth, const OwnPoses::Player& player) {
  return std::any_of(truth.robots.begin(), truth.robots.end(), [&](const FusedRobot& robot) {
    return robot.team == player.team && robot.player == player.number;
  });
}

void set_place(FusedPlace& place, FusedPlace better) {
  better.sensors = place.sensors;
  place = better;
}

void write_robot(std::vector<FusedTruth>& truths, const Passage& passage, const RobotTrail& trail,
                 const std::vector<Sensor>& sensors, const OwnPoses& known) {
  const std::vector<std::optional<FusedPlace>> places = smoothed_robot(trail.trail, sensors);
  for (std::size_t i = 0; i < places.size(); ++i) {
    const Moment& moment = trail.trail.moments[i];
    const FusedTruth& online = passage.truths[moment.image];
    FusedRobot robot = report_at(online, moment);
    if (places[i]) set_place(robot.place, *places[i]);

    // a robot that is one player later was that player from the beginning
    if (trail.player && !trail.several_players && !contains(online, known.players()[*trail.player])) {
      robot.team = known.players()[*trail.player].team;
      robot.player = known.players()[*trail.player].number;
    }
    truths[moment.image].robots.push_back(robot);
  }
}

void write_ball(std::vector<FusedTruth>& truths, const Passage& passage, const Trail& trail,
                const std::vector<Sensor>& sensors) {
  const std::vector<std::optional<FusedPlace>> places = smoothed_ball(trail, sensors);
  for (std::size_t i = 0; i < places.size(); ++i) {
    if (!places[i]) continue;
    const std::size_t image = trail.moments[i].image;
    FusedBall ball = passage.truths[image].ball.value_or(FusedBall{});
    ball.place.sensors = std::max(1u, ball.place.sensors);
    set_place(ball.place, *places[i]);
    truths[image].ball = ball;
  }
}

Result<void> check_all(const std::vector<Sensor>& sensors, const std::vector<SensorImage>& images,
                       const std::vector<OwnPose>& poses) {
  if (sensors.size() > kMostSensors)
    return Error{formatted("sensors: expected at most %zu, got %zu", kMostSensors, sensors.size())};
  for (const SensorImage& image : images)
    if (const Result<void> checked = check_image(image, sensors.size()); !checked) return checked.failure();
  OwnPoses players;
  for (const OwnPose& pose : poses)
    if (const Result<void> checked = players.add(pose); !checked) return checked.failure();
  return {};
}

/// Brings the images into the order of their times, each once.
void put_in_order(std::vector<SensorImage>& images) {
  const auto order = [](const SensorImage& image) { return std::pair(image.detections.capture_ns, image.sensor); };
  std::stable_sort(images.begin(), images.end(),
                   [&](const SensorImage& a, const SensorImage& b) { return order(a) < order(b); });
  const auto same = [&](const SensorImage& a, const SensorImage& b) { return order(a) == order(b); };
  images.erase(std::unique(images.begin(), images.end(), same), images.end());
}

}  // namespace

Result<std::vector<FusedTruth>> smooth(const std::vector<Sensor>& sensors, std::vector<SensorImage> images,
                                       std::vector<OwnPose> poses) {
  if (const Result<void> checked = check_all(sensors, images, poses); !checked) return checked.failure();
  put_in_order(images);
  std::stable_sort(poses.begin(), poses.end(),
                   [](const OwnPose& a, const OwnPose& b) { return a.capture_ns < b.capture_ns; });

  OwnPoses known;
  Fusion fusion(sensors);
  Passage passage = passage_of(fusion, images, poses, known);
  std::vector<FusedTruth> truths = passage.truths;
  for (FusedTruth& truth : truths) {
    truth.robots.clear();
    truth.ball.reset();
  }
  for (const RobotTrail& trail : robots_of(passage, sensors)) write_robot(truths, passage, trail, sensors, known);
  for (const auto& [serial, trail] : passage.balls)
    if (trail.track != 0) write_ball(truths, passage, trail, sensors);
  for (FusedTruth& truth : truths)
    std::sort(truth.robots.begin(), truth.robots.end(),
              [](const FusedRobot& a, const FusedRobot& b) { return a.place.track < b.place.track; });
  return truths;
}

}  // namespace robot::truth
