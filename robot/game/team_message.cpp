#include "robot/game/team_message.h"

#include <algorithm>
#include <cmath>

#include "robot/core/little_endian.h"

namespace robot::game {
namespace {

// "FSgt", version, team, player, flags, sender (4). The other fields have two bytes each:
// pose x, y [mm], heading [1/10000 rad], deviations x, y [mm], heading [1/10000 rad],
// ball x, y [mm], velocity x, y [mm/s], deviation [mm], age [ms]
constexpr std::string_view kTeamLetters = "FSgt";
constexpr std::uint32_t kVersion = 2;
constexpr std::size_t kBytes = 38;
static_assert(kBytes <= kMaxTeamMessageBytes);

constexpr std::uint32_t kHasPose = 1, kHasBall = 2, kFallen = 4, kAllFlags = 7;
constexpr float kPerMetre = 1000, kPerRadian = 10'000;

void put_signed(std::string& out, float value, float scale) {
  const float scaled = std::clamp(std::round(value * scale), -32767.f, 32767.f);
  put(out, static_cast<std::int16_t>(scaled));
}

void put_unsigned(std::string& out, float value, float scale) {
  put(out, static_cast<std::uint16_t>(std::clamp(std::round(value * scale), 0.f, 65535.f)));
}

bool finite(const pb::Pose& pose) {
  return std::isfinite(pose.x()) && std::isfinite(pose.y()) && std::isfinite(pose.heading()) &&
         std::isfinite(pose.deviation_x()) && std::isfinite(pose.deviation_y()) &&
         std::isfinite(pose.deviation_heading());
}

bool finite(const pb::Ball& ball) {
  return std::isfinite(ball.x()) && std::isfinite(ball.y()) && std::isfinite(ball.velocity_x()) &&
         std::isfinite(ball.velocity_y()) && std::isfinite(ball.deviation());
}

void put_pose(std::string& out, const pb::Pose& pose) {
  put_signed(out, pose.x(), kPerMetre);
  put_signed(out, pose.y(), kPerMetre);
  put_signed(out, pose.heading(), kPerRadian);
  put_unsigned(out, pose.deviation_x(), kPerMetre);
  put_unsigned(out, pose.deviation_y(), kPerMetre);
  put_unsigned(out, pose.deviation_heading(), kPerRadian);
}

void put_ball(std::string& out, const pb::Ball& ball, std::uint64_t now_ns) {
  put_signed(out, ball.x(), kPerMetre);
  put_signed(out, ball.y(), kPerMetre);
  put_signed(out, ball.velocity_x(), kPerMetre);
  put_signed(out, ball.velocity_y(), kPerMetre);
  put_unsigned(out, ball.deviation(), kPerMetre);
  const std::uint64_t age_ns = now_ns - std::min(now_ns, ball.seen_ns());
  put(out, static_cast<std::uint16_t>(std::min<std::uint64_t>(age_ns / 1'000'000, 65'535)));
}

float signed_value(ByteReader& in, float scale) { return static_cast<float>(in.number<std::int16_t>()) / scale; }

float unsigned_value(ByteReader& in, float scale) { return static_cast<float>(in.number<std::uint16_t>()) / scale; }

pb::Pose read_pose(ByteReader& in) {
  pb::Pose pose;
  pose.set_x(signed_value(in, kPerMetre));
  pose.set_y(signed_value(in, kPerMetre));
  pose.set_heading(signed_value(in, kPerRadian));
  pose.set_deviation_x(unsigned_value(in, kPerMetre));
  pose.set_deviation_y(unsigned_value(in, kPerMetre));
  pose.set_deviation_heading(unsigned_value(in, kPerRadian));
  return pose;
}

pb::Ball read_ball(ByteReader& in, std::uint64_t now_ns) {
  pb::Ball ball;
  ball.set_x(signed_value(in, kPerMetre));
  ball.set_y(signed_value(in, kPerMetre));
  ball.set_velocity_x(signed_value(in, kPerMetre));
  ball.set_velocity_y(signed_value(in, kPerMetre));
  ball.set_deviation(unsigned_value(in, kPerMetre));
  const std::uint64_t age_ns = std::uint64_t{in.number<std::uint16_t>()} * 1'000'000;
  ball.set_seen_ns(now_ns - std::min(now_ns, age_ns));
  return ball;
}

}  // namespace

std::string to_bytes(const TeamMessage& message, std::uint64_t now_ns) {
  const bool has_pose = message.pose && finite(*message.pose), has_ball = message.ball && finite(*message.ball);
  std::string out(kTeamLetters);
  put(out, kVersion, 1);
  put(out, message.team, 1);
  put(out, message.player, 1);
  put(out, (has_pose ? kHasPose : 0) | (has_ball ? kHasBall : 0) | (message.fallen ? kFallen : 0), 1);
  put(out, message.sender, 4);
  put(out, message.strategy);
  put(out, message.epoch);
  put_pose(out, has_pose ? *message.pose : pb::Pose());
  put_ball(out, has_ball ? *message.ball : pb::Ball(), now_ns);
  return out;
}

Result<TeamMessage> parse_team_message(std::string_view bytes, std::uint64_t now_ns) {
  if (bytes.size() != kBytes || !bytes.starts_with(kTeamLetters))
    return Error{"team message: expected " + std::to_string(kBytes) + " bytes that begin with FSgt, got " +
                 std::to_string(bytes.size()) + " bytes"};
  ByteReader in(bytes.substr(kTeamLetters.size()));
  if (const auto version = in.number<std::uint8_t>(); version != kVersion)
    return Error{"team message: expected version " + std::to_string(kVersion) + ", got " + std::to_string(version)};
  TeamMessage message{.team = in.number<std::uint8_t>(), .player = in.number<std::uint8_t>()};
  const auto flags = in.number<std::uint8_t>();
  message.sender = in.number<std::uint32_t>();
  message.strategy = in.number<std::uint8_t>();
  message.epoch = in.number<std::uint8_t>();
  if (message.player < 1 || message.player > 20 || flags > kAllFlags)
    return Error{"team message: expected player 1 .. 20 and flags 0 .. 7, got player " +
                 std::to_string(message.player) + " and flags " + std::to_string(flags)};
  message.fallen = (flags & kFallen) != 0;
  const pb::Pose pose = read_pose(in);
  const pb::Ball ball = read_ball(in, now_ns);
  if (flags & kHasPose) message.pose = pose;
  if (flags & kHasBall) message.ball = ball;
  return message;
}

}  // namespace robot::game
