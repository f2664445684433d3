#include "robot/fit/localisation/watched_motion.h"

#include <algorithm>
#include <cmath>

#include "proto/foresight/camera.pb.h"
#include "proto/foresight/game.pb.h"
#include "proto/foresight/motion.pb.h"
#include "proto/foresight/pose.pb.h"
#include "robot/fit/math/angles.h"
#include "robot/logging/sessions/read_all.h"

namespace robot::fit {
namespace {

constexpr double kFarAway = 1000, kFastestBody = 3, kFastestTurn = 15;  // [m], [m/s], [rad/s] more is absurd
constexpr double kCrowdedWithin = 0.6;                                  // [m]

bool is_sane(double x, double y, double heading) {
  return std::isfinite(x + y + heading) && std::abs(x) < kFarAway && std::abs(y) < kFarAway;
}

/// Reads the topics of one robot.
class MotionReader {
 public:
  explicit MotionReader(const WatchedRobot& robot) : robot_(robot), topics_("/" + robot.session.info.robot + "/") {}

  void read_odometry(WatchedMotion& motion) const {
    read<foresight::Odometry>("odometry", [&](const foresight::Odometry& message, double at) {
      if (is_sane(message.x(), message.y(), message.heading()))
        motion.odometry.push_back({.at = at, .x = message.x(), .y = message.y(), .heading = message.heading()});
      else
        ++motion.damaged;
    });
  }

  void read_poses(WatchedMotion& motion) const {
    read<foresight::Pose>("pose", [&](const foresight::Pose& message, double at) {
      if (!is_sane(message.x(), message.y(), message.heading())) return void(++motion.damaged);
      PoseAt pose{.at = at, .x = message.x(), .y = message.y(), .heading = message.heading()};
      const double deviation = std::max(message.deviation_x(), message.deviation_y());
      if (std::isfinite(deviation) && deviation > 0) pose.deviation = deviation;
      if (std::isfinite(message.deviation_heading()) && message.deviation_heading() > 0)
        pose.deviation_heading = message.deviation_heading();
      motion.poses.push_back(pose);
    });
  }

  void read_status(WatchedMotion& motion) const {
    read<foresight::MotionStatus>("motion_status", [&](const foresight::MotionStatus& message, double at) {
      const double speed = std::hypot(message.velocity_x(), message.velocity_y());
      const double turn_rate = std::abs(message.turn_rate());
      // a comparison with NaN is false
      if (!(speed < kFastestBody && turn_rate < kFastestTurn)) return void(++motion.damaged);
      motion.status.push_back({.at = at, .body = body_of(message.fall()), .speed = speed, .turn_rate = turn_rate});
    });
  }

  void read_games(WatchedMotion& motion) const {
    using State = foresight::GameState;
    read<State>("game", [&](const State& message, double at) {
      const auto player = static_cast<int>(message.own_player());
      const bool known = player >= 1 && player <= message.own().players_size();
      const bool rests = message.state() == State::STATE_INITIAL || message.state() == State::STATE_STANDBY ||
                         message.state() == State::STATE_FINISHED;
      motion.games.push_back({.at = at,
                              .penalised = known && message.own().players(player - 1).penalised(),
                              .moves = !rests,
                              .plays = message.state() == State::STATE_PLAYING,
                              .half = static_cast<int>(message.half()),
                              .attacks_plus = message.has_attacks_positive_x()
                                                  ? std::optional(message.attacks_positive_x())
                                                  : std::nullopt});
      motion.is_simulated = motion.is_simulated || message.source() == State::SOURCE_SIMULATOR;
    });
  }

  void read_heads(WatchedMotion& motion) const {
    read<foresight::CameraMatrix>("camera_top_matrix", [&](const foresight::CameraMatrix& message, double at) {
      if (message.rotation_size() != 9 || !(message.focal_y() > 0)) return;
      // the column of the optical axis in the robot frame
      const double x = message.rotation(2), y = message.rotation(5), z = message.rotation(8);
      const double half = std::atan2(message.centre_y(), message.focal_y());
      if (std::isfinite(x + y + z + half))
        motion.heads.push_back(
            {.at = at, .yaw = std::atan2(y, x), .upper_edge = std::atan2(-z, std::hypot(x, y)) - half});
    });
  }

 private:
  static StatusAt::Body body_of(foresight::MotionStatus::Fall fall) {
    using Status = foresight::MotionStatus;
    if (fall == Status::FALL_FALLING || fall == Status::FALL_FALLEN) return StatusAt::Body::fallen;
    return fall == Status::FALL_GETTING_UP ? StatusAt::Body::getting_up : StatusAt::Body::upright;
  }

  template <class Message, class Visit>
  void read(const std::string& topic, Visit&& visit) const {
    logging::read_each<Message>(robot_.session, topics_ + topic, [&](const Message& message, std::uint64_t capture_ns) {
      visit(message, robot_.true_seconds(capture_ns));
    });
  }

  const WatchedRobot& robot_;
  const std::string topics_;
};

/// Follows the other robots of the truth in time.
class OtherRobots {
 public:
  explicit OtherRobots(const lab::TruthRecord& record) : record_(record), next_(record.robots.size()) {}

  bool are_near(const lab::PlaceAt& own) {
    for (std::size_t i = 0; i < record_.robots.size(); ++i) {
      const lab::Path& path = record_.robots[i].path;
      std::size_t& next = next_[i];
      while (next < path.size() && path[next].at < own.at) ++next;
      if (next == path.size() || path[next].at > own.at + lab::SmoothCurve::kLongestGap) continue;
      const lab::PlaceAt& other = path[next];
      const bool is_own = other.at == own.at && other.x == own.x && other.y == own.y;
      if (!is_own && std::hypot(other.x - own.x, other.y - own.y) < kCrowdedWithin) return true;
    }
    return false;
  }

 private:
  const lab::TruthRecord& record_;
  std::vector<std::size_t> next_;
};

template <class Item>
void order_by_time(std::vector<Item>& items) {
  std::ranges::stable_sort(items, {}, &Item::at);
}

}  // namespace

std::vector<TrueMoment> true_moments(const lab::Path& own, const lab::TruthRecord& record) {
  OtherRobots others(record);
  std::vector<TrueMoment> moments;
  for (const lab::PlaceAt& place : own) {
    if (!std::isfinite(place.heading) || !is_sane(place.x, place.y, place.heading)) continue;
    moments.push_back({.at = place.at,
                       .x = place.x,
                       .y = place.y,
                       .heading = place.heading,
                       .fallen = place.fallen.value_or(false),
                       .crowded = others.are_near(place)});
  }
  return moments;
}

std::optional<TrueMoment> TruthReader::at(double seconds) {
  while (next_ < truth_.size() && truth_[next_].at < seconds) ++next_;
  if (next_ == truth_.size()) return std::nullopt;
  const TrueMoment& after = truth_[next_];
  if (after.at == seconds) return after;
  if (next_ == 0 || after.at - truth_[next_ - 1].at > lab::SmoothCurve::kLongestGap) return std::nullopt;
  const TrueMoment& before = truth_[next_ - 1];
  const double part = (seconds - before.at) / (after.at - before.at);
  return TrueMoment{.at = seconds,
                    .x = before.x + part * (after.x - before.x),
                    .y = before.y + part * (after.y - before.y),
                    .heading = wrapped(before.heading + part * wrapped(after.heading - before.heading)),
                    .fallen = before.fallen || after.fallen,
                    .crowded = before.crowded || after.crowded,
                    .noise = part * part + (1 - part) * (1 - part)};
}

WatchedMotion read_motion(const WatchedRobot& robot, const WatchedTopics& topics) {
  WatchedMotion motion;
  motion.name = robot.name;
  motion.place_deviation = robot.game->record.ball_deviation;
  motion.truth = true_moments(robot.path, robot.game->record);
  if (!motion.truth.empty()) motion.clock_deviation = robot.clock.deviation_at(motion.truth.front().at);
  const MotionReader reader(robot);
  if (topics.odometry) reader.read_odometry(motion);
  if (topics.poses) reader.read_poses(motion);
  if (topics.heads) reader.read_heads(motion);
  reader.read_status(motion);
  reader.read_games(motion);
  order_by_time(motion.odometry);
  order_by_time(motion.poses);
  order_by_time(motion.status);
  order_by_time(motion.games);
  order_by_time(motion.heads);
  return motion;
}

}  // namespace robot::fit
