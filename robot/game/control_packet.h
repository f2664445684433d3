// Packets of the GameController, of every format from 2012 to 2025, as messages.
#pragma once

#include <array>
#include <optional>
#include <string_view>

#include "proto/foresight/game.pb.h"
#include "robot/core/result.h"

namespace robot::game {

namespace pb = foresight;

/// What one packet says, seen by nobody in particular.
struct ControlPacket {
  pb::GameState game;  // without what depends on who looks: the two teams, our number, the time of arrival
  std::array<pb::TeamState, 2> teams;
};

/// Reads the payload of a UDP packet; its format is told by its own version. An Error where the letters, the version, the
/// length or a value is not one of that format. Pure, any thread.
///
/// A penalty or colour that the format does not name is no error: its code is kept. A kicking team that is neither of the
/// two is absent, as is one that is hidden.
Result<ControlPacket> parse_control_packet(std::string_view bytes);

/// The game as a robot of team `own_team` sees it; nothing if neither of the two teams is its own.
std::optional<pb::GameState> seen_by(const ControlPacket& packet, std::uint32_t own_team, std::uint32_t own_player);

}  // namespace robot::game
