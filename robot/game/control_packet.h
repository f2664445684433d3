// Parser for the GameController's packets of every format from 2012 to 2026.
#pragma once

#include <array>
#include <optional>
#include <string_view>

#include "proto/foresight/game.pb.h"
#include "robot/core/result.h"

namespace robot::game {

namespace pb = foresight;

/// The content of one packet, from no team's point of view.
struct ControlPacket {
  pb::GameState game;  // without the fields that depend on the receiver: both teams, our number, the time of arrival
  std::array<pb::TeamState, 2> teams;
};

/// Parses the payload of a UDP packet; its version number selects the format. Returns an Error if the letters, the
/// version, the length or a value is wrong for that format. Pure, any thread.
///
/// A penalty or colour without a name in the format is no error: its code is kept. The kicking team is absent if it is
/// hidden or is neither of the two teams.
Result<ControlPacket> parse_control_packet(std::string_view bytes);

/// Returns a game of which only `packet_version` and `unreadable` are known, if `bytes` may be a packet about team
/// `own_team` in a format that parse_control_packet() cannot read. Otherwise returns nothing.
///
/// Such a packet begins with the letters, and its version is above kNewestVersion or its length is not that of its version.
/// It must also name the team. The place of the number is not known, so any byte after the version counts. A game of two
/// other teams may therefore count as ours. That costs a recording; the opposite would break a rule of the match.
/// Pure, any thread.
std::optional<pb::GameState> unreadable_game(std::string_view bytes, std::uint32_t own_team, std::uint32_t own_player);

/// Returns the game from the point of view of team `own_team`, or nothing if it is not one of the two teams.
std::optional<pb::GameState> seen_by(const ControlPacket& packet, std::uint32_t own_team, std::uint32_t own_player);

}  // namespace robot::game
