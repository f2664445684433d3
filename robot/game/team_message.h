// Messages between robots with our own behaviour: UDP packets of 38 bytes, where the rules allow 128.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

#include "proto/foresight/ball.pb.h"
#include "proto/foresight/pose.pb.h"
#include "proto/foresight/team.pb.h"
#include "robot/core/result.h"

namespace robot::game {

namespace pb = foresight;

/// The longest payload the rules allow since 2023 [bytes].
inline constexpr std::size_t kMaxTeamMessageBytes = 128;

/// The UDP port of team messages is 10000 + team number.
inline constexpr std::uint16_t kTeamPortBase = 10'000;

/// The value of `TeamMessage::strategy` when the robot follows no choice.
inline constexpr std::uint8_t kNoStrategy = 0xff;

/// One team message.
struct TeamMessage {
  std::uint32_t team = 0, player = 0;
  std::uint32_t sender = 0;  // random, drawn at program start: it differs between two programs with one player number
  bool fallen = false;
  std::uint8_t strategy = kNoStrategy, epoch = 0;  // the team's choice that it follows (sim/agent/choice.h)
  std::optional<pb::Pose> pose;                    // [team_field] position, heading and their deviations
  std::optional<pb::Ball> ball;                    // [robot] position, velocity, deviation; `seen_ns` by the own clock
};

/// Returns the packet. Positions are in millimetres within ±32 m, angles in 1/10000 rad, deviations at most 65 m. A
/// pose or ball with a value that is not finite is left out. The ball's age is counted to `now_ns`.
std::string to_bytes(const TeamMessage& message, std::uint64_t now_ns);

/// Parses a packet that arrived at `now_ns`, from which `ball.seen_ns` is counted. Returns an Error for any other
/// packet, such as that of another team's program.
Result<TeamMessage> parse_team_message(std::string_view bytes, std::uint64_t now_ns);

}  // namespace robot::game
