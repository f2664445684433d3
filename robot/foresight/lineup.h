// Who of a team plays as which player of the simulator.
#pragma once

#include <array>
#include <cstdint>
#include <string>

#include "proto/foresight/game.pb.h"
#include "sim/world/world.h"

namespace robot::foreseeing {

namespace pb = ::foresight;

/// [1..20] Who keeps the goal: whom the GameController names, or number 1 where its format names nobody.
std::uint32_t keeper_of(const pb::TeamState& team);

/// On the field jersey numbers are 1 .. 20, some of them substitutes', and any of them may keep. The simulator has players
/// 1 .. 7, of whom the first keeps. So the goalkeeper has the first place and all others who are no substitutes follow by
/// their numbers, as far as there are places. Who is penalised keeps his.
class Lineup {
 public:
  /// Of up to `places` [1..7] players. Where the GameController has told nothing of the team all have their own numbers.
  Lineup(const pb::TeamState& team, int places);

  /// [1..places] of jersey number `player`; 0: he does not play.
  int place_of(std::uint32_t player) const;
  /// [1..20] whose place [1..7] that is; 0: nobody's.
  std::uint32_t player_at(int place) const { return players_[static_cast<std::size_t>(place - 1)]; }

  /// "2, 3, 5, 8": all that play.
  std::string text() const;

 private:
  std::array<std::uint32_t, sim::kMaxPlayers> players_ = {};  // by place
};

/// Both teams', one's own is the simulator's home side.
struct Lineups {
  Lineup own, opponents;

  Lineups(const pb::GameState& game, int places) : own(game.own(), places), opponents(game.opponent(), places) {}
  const Lineup& of(sim::Side side) const { return side == sim::Side::home ? own : opponents; }
};

}  // namespace robot::foreseeing
