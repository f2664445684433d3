// A game in one line of JSON, for the evaluation of thousands of games.
#pragma once

#include <cstdint>
#include <string>

#include "sim/match/params.h"

namespace sim::report {

/// The figures of a game as one line of JSON with its newline, and the hash of the game (hash_of_game).
struct GameLine {
  std::string text;
  std::uint64_t hash = 0;
};

/// Plays a game and returns its figures: those of its report, the time of the first goal and the number of balls out.
/// With `shoot_out` a drawn game has a penalty shoot-out. Each robot's share of time with the ball in view and the figures
/// of a Census follow.
GameLine game_line(const Params& params, std::uint64_t seed, bool shoot_out = false);

}  // namespace sim::report
