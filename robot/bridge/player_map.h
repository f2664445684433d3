// Jersey numbers of real teams and the players of the simulator.
#pragma once

#include <array>
#include <cstdint>
#include <string>

#include "proto/foresight/game.pb.h"
#include "sim/world/world.h"

namespace robot::bridge {

namespace pb = ::foresight;

/// Returns the goalkeeper's number [1..20]: the one that the GameController names, or 1 if its format names none.
std::uint32_t keeper_of(const pb::TeamState& team);

/// The players of one team by their places in the simulator.
///
/// Jersey numbers are 1 .. 20. Some belong to substitutes, and any player may be the goalkeeper. The simulator has
/// players 1 .. 7 and the first is the goalkeeper. So the goalkeeper gets the first place. The others, without
/// substitutes, follow by their numbers as long as there are places. A penalised player keeps its place.
class PlayerMap {
 public:
  /// Maps up to `places` [1..7] players. Without data from the GameController each place has its own number.
  PlayerMap(const pb::TeamState& team, int places);

  /// Returns the place [1..places] of jersey number `player`, or 0 if it does not play.
  int place_of(std::uint32_t player) const;
  /// Returns the jersey number [1..20] at a place [1..7], or 0 if the place is empty.
  std::uint32_t player_at(int place) const { return players_[static_cast<std::size_t>(place - 1)]; }

  /// Returns the numbers of all players, such as "2, 3, 5, 8".
  std::string text() const;

 private:
  std::array<std::uint32_t, sim::kMaxPlayers> players_ = {};  // by place
};

/// The maps of both teams. The own team is the simulator's home side.
struct PlayerMaps {
  PlayerMap own, opponents;

  PlayerMaps(const pb::GameState& game, int places) : own(game.own(), places), opponents(game.opponent(), places) {}
  const PlayerMap& of(sim::Side side) const { return side == sim::Side::home ? own : opponents; }
};

}  // namespace robot::bridge
