// A game in one line of JSON, for the evaluation of thousands of games.
#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "sim/match/play.h"
#include "sim/report/census.h"

namespace sim::report {

/// The figures of a game as one line of JSON with its newline, and the hash of the game (hash_of_game).
struct GameLine {
  std::string text;
  std::uint64_t hash = 0;
};

/// A game that is measured for its line.
class LineGame {
 public:
  State state;

  LineGame(const Params& params, std::uint64_t seed);

  /// Measures the state. Call it before each step.
  bool goes_on();
  /// Counts the decisions of the last step.
  void see(const referee::Events& events);
  /// Returns the figures after the last step: those of a report, the time of the first goal, and the number of balls out.
  /// Each robot's share of time with the ball in view and the figures of a Census follow. With `shoot_out` a drawn game has
  /// a penalty shoot-out.
  GameLine line(const Params& params, bool shoot_out) const;

 private:
  std::uint64_t seed_;
  Census census_;
  Result decided_{};
  int outs_ = 0;
  std::optional<Tick> first_goal_;
};

}  // namespace sim::report
