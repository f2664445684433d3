#include "robot/fit/ball_noise/seen_balls.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

#include "proto/foresight/ball.pb.h"
#include "proto/foresight/motion.pb.h"
#include "proto/foresight/vision.pb.h"
#include "robot/logging/sessions/read_all.h"

namespace robot::fit {
namespace {

constexpr double kSlowestWriting = 1;    // [s]
constexpr double kMostUnchanged = 0.05;  // share of messages that were written at their capture time
constexpr std::size_t kFewestWritten = 20;

Gait gait_of(const foresight::MotionStatus& status) {
  using foresight::MotionStatus;
  if (status.fall() != MotionStatus::FALL_UNSPECIFIED && status.fall() != MotionStatus::FALL_UPRIGHT) return Gait::down;
  return status.standing() ? Gait::standing : Gait::moving;
}

double delay_of(const logging::Record& record) {
  return static_cast<double>(static_cast<std::int64_t>(record.publish_ns - record.capture_ns)) * 1e-9;
}

}  // namespace

SeenBalls read_seen_balls(const WatchedRobot& robot) {
  SeenBalls seen{.robot = &robot};
  const std::string before = "/" + robot.session.info.robot + "/";
  logging::read_each<foresight::MotionStatus>(
      robot.session, before + "motion_status", [&](const foresight::MotionStatus& status, std::uint64_t capture_ns) {
        seen.gaits.push_back({.capture_ns = capture_ns, .gait = gait_of(status)});
      });
  std::vector<double> of_vision, of_belief;
  logging::read_records<foresight::Vision>(
      robot.session, before + "vision", [&](const foresight::Vision& vision, const logging::Record& record) {
        of_vision.push_back(delay_of(record));
        if (!vision.has_ball()) return;
        const foresight::Detection& ball = vision.ball().detection();
        seen.percepts.push_back(
            {.capture_ns = record.capture_ns, .distance = ball.distance(), .bearing = ball.bearing()});
      });
  logging::read_records<foresight::Ball>(
      robot.session, before + "ball", [&](const foresight::Ball& ball, const logging::Record& record) {
        of_belief.push_back(delay_of(record));
        if (!ball.visible()) return;
        const double x = ball.x(), y = ball.y();
        seen.beliefs.push_back(
            {.capture_ns = record.capture_ns, .distance = std::hypot(x, y), .bearing = std::atan2(y, x)});
      });
  // a simulated robot thinks in no time
  if (robot.session.info.profile == "sim") return seen;
  seen.writing = writing_time(std::move(of_belief));
  if (!seen.writing) seen.writing = writing_time(std::move(of_vision));
  return seen;
}

std::optional<double> writing_time(std::vector<double> delays) {
  if (delays.size() < kFewestWritten) return std::nullopt;
  const auto unchanged = static_cast<double>(std::ranges::count_if(delays, [](double delay) { return delay <= 0; }));
  if (unchanged > kMostUnchanged * static_cast<double>(delays.size())) return std::nullopt;
  const double middle = lab::median_of(std::move(delays));
  if (middle >= kSlowestWriting) return std::nullopt;
  return middle;
}

}  // namespace robot::fit
