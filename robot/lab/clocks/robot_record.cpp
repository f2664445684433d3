#include "robot/lab/clocks/robot_record.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "proto/foresight/ball.pb.h"
#include "proto/foresight/pose.pb.h"
#include "proto/foresight/vision.pb.h"
#include "robot/logging/sessions/read_all.h"

namespace robot::lab {
namespace {

constexpr std::size_t kEnoughImages = 300;  // with a ball; with fewer the belief is the better source

/// The times of a record.
struct Epoch {
  std::uint64_t epoch_ns;
  double operator()(std::uint64_t time_ns) const {
    return static_cast<double>(static_cast<std::int64_t>(time_ns - epoch_ns)) * 1e-9;
  }
};

/// The ball, as one source saw it.
struct Seen {
  std::vector<Sighting> sightings;
  Series ranges;

  void add(double at, bool seen, double range) {
    sightings.push_back({.at = at, .seen = seen});
    if (seen) ranges.push_back({.at = at, .value = range});
  }
};

Seen seen_in_images(const logging::Session& session, const std::string& topic, const Epoch& epoch) {
  Seen seen;
  logging::read_each<foresight::Vision>(session, topic, [&](const foresight::Vision& vision, std::uint64_t capture_ns) {
    const float distance = vision.ball().detection().distance();
    seen.add(epoch(capture_ns), vision.has_ball() && distance > 0, static_cast<double>(distance));
  });
  return seen;
}

}  // namespace

RobotRecord read_robot(const logging::Session& session, std::uint64_t epoch_ns) {
  const Epoch epoch{epoch_ns};
  RobotRecord record{.name = session.info.robot, .balls = {}, .poses = {}, .sightings = {}, .ranges = {}};
  const std::string topics = "/" + record.name + "/";
  Seen believed;
  logging::read_each<foresight::Ball>(
      session, topics + "ball", [&](const foresight::Ball& ball, std::uint64_t capture_ns) {
        if (!std::isfinite(ball.x()) || !std::isfinite(ball.y())) return;
        believed.add(epoch(capture_ns), ball.visible(), std::hypot(ball.x(), ball.y()));
        if (ball.visible()) record.balls.push_back({.at = epoch(capture_ns), .x = ball.x(), .y = ball.y()});
      });
  logging::read_each<foresight::Pose>(
      session, topics + "pose", [&](const foresight::Pose& pose, std::uint64_t capture_ns) {
        if (std::isfinite(pose.x()) && std::isfinite(pose.y()) && std::isfinite(pose.heading()))
          record.poses.push_back({.at = epoch(capture_ns), .x = pose.x(), .y = pose.y(), .heading = pose.heading()});
      });
  Seen pictured = seen_in_images(session, topics + "vision", epoch);
  Seen& best = pictured.ranges.size() >= kEnoughImages ? pictured : believed;
  record.sightings = std::move(best.sightings);
  record.ranges = tidied(std::move(best.ranges));
  std::ranges::stable_sort(record.balls, {}, &BallBelief::at);
  std::ranges::stable_sort(record.poses, {}, &PoseBelief::at);
  return record;
}

}  // namespace robot::lab
