#include "robot/game/team_message.h"

#include <algorithm>
#include <cmath>

#include "robot/game/little_endian.h"

namespace robot::game {
namespace {

// "FSgt", version, team, player, flags, sender (4), then fields of two bytes each:
// pose x, y [mm], heading [1/10000 rad], deviations x, y [mm], heading [1/10000 rad],
// ball x, y [mm], velocity x, y [mm/s], deviation [mm], age [ms]
constexpr std::string_view kLetters = "FSgt";
constexpr std::uint32_t kVersion = 1;
constexpr std::size_t kBytes = 36;
static_assert(kBytes <= kMaxTeamMessageBytes);

constexpr std::uint32_t kHasPose = 1, kHasBall = 2, kFallen = 4, kAllFlags = 7;
constexpr float kPerMetre = 1000, kPerRadian = 10'000;

void put_signed(std::string& out, float value, float scale) {
  const float scaled = std::clamp(std::round(value * scale), -32767.f, 32767.f);
  put_number(out, static_cast<std::uint16_t>(static_cast<std::int16_t>(scaled)), 2);
}

void put_unsigned(std::string& out, float value, float scale) {
  put_number(out, static_cast<std::uint16_t>(std::clamp(std::round(value * scale), 0.f, 65535.f)), 2);
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
  put_number(out, static_cast<std::uint32_t>(std::min<std::uint64_t>(age_ns / 1'000'000, 65'535)), 2);
}

class Reader {
 public:
  explicit Reader(std::string_view rest) : rest_(rest) {}

  std::uint32_t number(std::size_t bytes) {
    const std::uint32_t number = number_of(rest_, bytes);
    rest_.remove_prefix(bytes);
    return number;
  }
  float signed_value(float scale) { return static_cast<float>(static_cast<std::int16_t>(number(2))) / scale; }
  float unsigned_value(float scale) { return static_cast<float>(number(2)) / scale; }

 private:
  std::string_view rest_;
};

pb::Pose read_pose(Reader& in) {
  pb::Pose pose;
  pose.set_x(in.signed_value(kPerMetre));
  pose.set_y(in.signed_value(kPerMetre));
  pose.set_heading(in.signed_value(kPerRadian));
  pose.set_deviation_x(in.unsigned_value(kPerMetre));
  pose.set_deviation_y(in.unsigned_value(kPerMetre));
  pose.set_deviation_heading(in.unsigned_value(kPerRadian));
  return pose;
}

pb::Ball read_ball(Reader& in, std::uint64_t now_ns) {
  pb::Ball ball;
  ball.set_x(in.signed_value(kPerMetre));
  ball.set_y(in.signed_value(kPerMetre));
  ball.set_velocity_x(in.signed_value(kPerMetre));
  ball.set_velocity_y(in.signed_value(kPerMetre));
  ball.set_deviation(in.unsigned_value(kPerMetre));
  const std::uint64_t age_ns = std::uint64_t{in.number(2)} * 1'000'000;
  ball.set_seen_ns(now_ns - std::min(now_ns, age_ns));
  return ball;
}

}  // namespace

std::string to_bytes(const TeamMessage& message, std::uint64_t now_ns) {
  const bool has_pose = message.pose && finite(*message.pose), has_ball = message.ball && finite(*message.ball);
  std::string out(kLetters);
  put_number(out, kVersion, 1);
  put_number(out, message.team, 1);
  put_number(out, message.player, 1);
  put_number(out, (has_pose ? kHasPose : 0) | (has_ball ? kHasBall : 0) | (message.fallen ? kFallen : 0), 1);
  put_number(out, message.sender, 4);
  put_pose(out, has_pose ? *message.pose : pb::Pose());
  put_ball(out, has_ball ? *message.ball : pb::Ball(), now_ns);
  return out;
}

Result<TeamMessage> parse_team_message(std::string_view bytes, std::uint64_t now_ns) {
  if (bytes.size() != kBytes || !bytes.starts_with(kLetters))
    return Error{"team message: expected " + std::to_string(kBytes) + " bytes that begin with FSgt, got " +
                 std::to_string(bytes.size()) + " bytes"};
  Reader in(bytes.substr(kLetters.size()));
  if (const std::uint32_t version = in.number(1); version != kVersion)
    return Error{"team message: expected version " + std::to_string(kVersion) + ", got " + std::to_string(version)};
  TeamMessage message{.team = in.number(1), .player = in.number(1)};
  const std::uint32_t flags = in.number(1);
  message.sender = in.number(4);
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
