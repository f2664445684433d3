// What robots with our own behaviour tell each other: one UDP packet of 38 bytes, of which the rules allow 128.
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

/// Team messages go to UDP port 10000 + number of the team.
inline constexpr std::uint16_t kTeamPortBase = 10'000;

inline constexpr std::uint8_t kNoStrategy = 0xff;

struct TeamMessage {
  std::uint32_t team = 0, player = 0;
  std::uint32_t sender = 0;  // by chance, once per start of the program: two programs with one number differ in it
  bool fallen = false;
  std::uint8_t strategy = kNoStrategy, epoch = 0;  // the team's choice that it follows (sim/agent/choice.h)
  std::optional<pb::Pose> pose;                    // [team_field] position, heading and their deviations
  std::optional<pb::Ball> ball;                    // [robot] position, velocity, deviation; `seen_ns` by the own clock
};

/// The packet. Positions in millimetres within ±32 m, angles in 1/10000 rad; deviations grow at most to 65 m. What is not a
/// number is left out. `now_ns` is the time by which the ball's age is told.
std::string to_bytes(const TeamMessage& message, std::uint64_t now_ns);

/// Reads one; `now_ns` is the time of arrival, by which `ball.seen_ns` is set. An Error for anything else, such as the
/// message of another team's program.
Result<TeamMessage> parse_team_message(std::string_view bytes, std::uint64_t now_ns);

}  // namespace robot::game
