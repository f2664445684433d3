// Parser for the GameController's packets of every format from 2012 to 2025.
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

/// Returns the game from the point of view of team `own_team`, or nothing if it is not one of the two teams.
std::optional<pb::GameState> seen_by(const ControlPacket& packet, std::uint32_t own_team, std::uint32_t own_player);

}  // namespace robot::game
