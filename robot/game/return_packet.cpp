#include "robot/game/return_packet.h"

#include <cmath>

#include "robot/core/little_endian.h"

namespace robot::game {
namespace {

constexpr std::uint32_t kAlive2 = 2, kAlive3 = 0;  // GAMECONTROLLER_RETURN_MSG_ALIVE of return versions 2 and 3
constexpr float kNeverSeen = -1;                   // [s] as age of the ball

std::string head(std::uint32_t return_version) {
  std::string packet = "RGrt";
  put(packet, return_version, 1);
  return packet;
}

std::string short_packet(std::uint32_t return_version, std::uint32_t alive, const RobotStatus& status) {
  std::string packet = head(return_version);
  put(packet, status.team, 1);
  put(packet, status.player, 1);
  put(packet, alive, 1);
  return packet;
}

std::string packet_4(const RobotStatus& status) {
  std::string packet = head(4);
  put(packet, status.player, 1);
  put(packet, status.team, 1);
  const bool fallen = status.motion != nullptr && (status.motion->fall() == pb::MotionStatus::FALL_FALLEN ||
                                                   status.motion->fall() == pb::MotionStatus::FALL_GETTING_UP);
  put(packet, fallen ? 1 : 0, 1);

  // its frame is our team_field, in millimetres
  const pb::Pose* const pose = status.pose;
  const bool known =
      pose != nullptr && std::isfinite(pose->x()) && std::isfinite(pose->y()) && std::isfinite(pose->heading());
  put(packet, known ? pose->x() * 1000 : 0.f);
  put(packet, known ? pose->y() * 1000 : 0.f);
  put(packet, known ? pose->heading() : 0.f);

  const pb::Ball* const ball = status.ball;
  const bool seen = ball != nullptr && std::isfinite(ball->x()) && std::isfinite(ball->y());
  const std::uint64_t age_ns = seen && status.now_ns > ball->seen_ns() ? status.now_ns - ball->seen_ns() : 0;
  put(packet, seen ? static_cast<float>(age_ns) / 1e9f : kNeverSeen);
  put(packet, seen ? ball->x() * 1000 : 0.f);
  put(packet, seen ? ball->y() * 1000 : 0.f);
  return packet;
}

}  // namespace

std::optional<std::string> return_packet(std::uint32_t version, const RobotStatus& status) {
  if (version < 9 || version > 20) return std::nullopt;
  if (version <= 10) return short_packet(2, kAlive2, status);
  if (version <= 13) return short_packet(3, kAlive3, status);
  return packet_4(status);
}

}  // namespace robot::game
