#include "robot/truth/feeds/ssl_packet.h"

#include <algorithm>
#include <cmath>

#include "proto/ssl_vision/wrapper.pb.h"
#include "robot/core/text.h"
#include "robot/truth/feeds/angle.h"
#include "robot/truth/feeds/timed_truth.h"

namespace robot::truth {
namespace {

constexpr double kFarthest = 50;        // [m]
constexpr double kLongestLatency = 10;  // [s]
constexpr int kMostThings = 64;         // of a kind in one image

/// The numbers of one list of things in a frame. The first wrong one is kept as a sentence.
class Checked {
 public:
  Checked(const ssl_vision::DetectionFrame& frame, const char* list) : frame_(frame), list_(list) {}

  double number(double value, double limit, const char* field, int index, const char* unit) {
    if (std::abs(value) <= limit) return value;
    fault_ = formatted("camera %u, frame %u, %s[%d].%s: expected %g .. %g%s, got %g", frame_.camera_id(),
                       frame_.frame_number(), list_, index, field, -limit, limit, unit, value);
    return 0;
  }
  /// Returns a length in metres.
  double metres(double millimetres, const char* field, int index) {
    return number(millimetres, 1000 * kFarthest, field, index, " [mm]") / 1000;
  }
  /// Returns a share from 0 to 1. Some simulators send a confidence above 1.
  double share(double value, int index) { return std::clamp(number(value, 1e6, "confidence", index, ""), 0.0, 1.0); }
  void count(int things) {
    if (things > kMostThings)
      fault_ = formatted("camera %u, frame %u: expected at most %d %s, got %d", frame_.camera_id(),
                         frame_.frame_number(), kMostThings, list_, things);
  }
  const std::string& fault() const { return fault_; }

 private:
  const ssl_vision::DetectionFrame& frame_;
  const char* list_;
  std::string fault_;
};

Result<void> add_balls(const ssl_vision::DetectionFrame& frame, SslView& view) {
  Checked checked(frame, "balls");
  checked.count(frame.balls_size());
  for (int i = 0; checked.fault().empty() && i < frame.balls_size(); ++i) {
    const ssl_vision::DetectionBall& ball = frame.balls(i);
    view.balls.push_back({.x = checked.metres(ball.x(), "x", i),
                          .y = checked.metres(ball.y(), "y", i),
                          .confidence = checked.share(ball.confidence(), i)});
  }
  if (!checked.fault().empty()) return Error{checked.fault()};
  return {};
}

using Robots = google::protobuf::RepeatedPtrField<ssl_vision::DetectionRobot>;

/// The robots of one colour.
struct Side {
  const Robots& robots;
  const char* name;  // of the list
  std::uint32_t team;
};

Result<void> add_robots(const ssl_vision::DetectionFrame& frame, const Side& side, SslPacket& packet) {
  Checked checked(frame, side.name);
  checked.count(side.robots.size());
  for (int i = 0; checked.fault().empty() && i < side.robots.size(); ++i) {
    const ssl_vision::DetectionRobot& robot = side.robots[i];
    SslRobot seen{.team = side.team,
                  .x = checked.metres(robot.x(), "x", i),
                  .y = checked.metres(robot.y(), "y", i),
                  .confidence = checked.share(robot.confidence(), i)};
    if (robot.has_orientation())
      seen.heading = in_one_turn(checked.number(robot.orientation(), 1000, "orientation", i, " [rad]"));
    if (robot.has_robot_id() && robot.robot_id() >= 1 && robot.robot_id() <= kMaxPlayer)
      seen.player = robot.robot_id();
    else if (robot.has_robot_id())
      packet.warning =
          formatted("camera %u, %s[%d].robot_id: expected a player 1 .. %u, got %u; this robot has no number",
                    frame.camera_id(), side.name, i, kMaxPlayer, robot.robot_id());
    packet.view->robots.push_back(seen);
  }
  if (!checked.fault().empty()) return Error{checked.fault()};
  return {};
}

Result<void> add_view(const ssl_vision::DetectionFrame& frame, const SslTeams& teams, SslPacket& packet) {
  if (frame.camera_id() >= kMaxSslCameras)
    return Error{formatted("camera_id: expected 0 .. %u, got %u", kMaxSslCameras - 1, frame.camera_id())};
  const double latency = frame.t_sent() - frame.t_capture();
  if (!(latency >= 0 && latency <= kLongestLatency))
    return Error{formatted("camera %u, frame %u: expected t_sent %g .. %g s after t_capture, got %g", frame.camera_id(),
                           frame.frame_number(), 0.0, kLongestLatency, latency)};
  packet.view = {.camera = frame.camera_id(),
                 .frame = frame.frame_number(),
                 .sent = frame.t_sent(),
                 .latency_ns = static_cast<std::uint64_t>(std::llround(latency * 1e9))};
  if (Result<void> added = add_balls(frame, *packet.view); !added) return added;
  for (const Side& side : {Side{frame.robots_yellow(), "robots_yellow", teams.yellow},
                           Side{frame.robots_blue(), "robots_blue", teams.blue}})
    if (Result<void> added = add_robots(frame, side, packet); !added) return added;
  return {};
}

/// Returns the size of the field, or nothing for implausible numbers: before 2014 they had other meanings.
std::optional<SslField> field_of(const ssl_vision::GeometryData& geometry) {
  if (!geometry.IsInitialized()) return std::nullopt;
  const ssl_vision::GeometryFieldSize& size = geometry.field();
  const auto plausible = [](int millimetres) { return millimetres >= 1000 && millimetres <= 1000 * kFarthest; };
  if (!plausible(size.field_length()) || !plausible(size.field_width())) return std::nullopt;
  return SslField{.length = size.field_length() / 1000.0,
                  .width = size.field_width() / 1000.0,
                  .border = std::clamp(size.boundary_width() / 1000.0, 0.0, kFarthest)};
}

}  // namespace

Result<SslPacket> read_ssl_packet(std::string_view bytes, const SslTeams& teams) {
  ssl_vision::WrapperPacket wrapper;
  if (!wrapper.ParsePartialFromArray(bytes.data(), static_cast<int>(bytes.size())))
    return Error{formatted("expected a packet of SSL-Vision, got %zu other bytes", bytes.size())};
  if (!wrapper.has_detection() && !wrapper.has_geometry())
    return Error{formatted("expected a packet with a detection or a geometry, got %zu bytes without", bytes.size())};
  SslPacket packet;
  if (wrapper.has_geometry()) packet.field = field_of(wrapper.geometry());
  if (!wrapper.has_detection()) return packet;
  if (!wrapper.detection().IsInitialized())
    return Error{"expected a whole detection, it lacks " + wrapper.detection().InitializationErrorString()};
  if (Result<void> added = add_view(wrapper.detection(), teams, packet); !added) return added.failure();
  return packet;
}

}  // namespace robot::truth
