// What foresight is asked.
#pragma once

#include <array>

#include "sim/math/tick.h"
#include "sim/world/world.h"

namespace sim::foresight {

/// By what one future is better than another. Each is a number that should be large.
enum class Measure : std::uint8_t {
  goal_difference,  // goals of one's own less those of the others, and what the ball's place at the end is worth
  score_next,       // 1 where the next goal is one's own
  concede,          // -1 where the next goal is the others'
};

/// How far it looks.
enum class Until : std::uint8_t {
  horizon,    // for Question::horizon of game time
  next_goal,  // to the next goal, but no further than the horizon where one is given
  half,       // to the end of the half
  game,
};

/// As people write them, by enumerator.
inline constexpr std::array kMeasureNames = {"goal_difference", "score_next", "concede"};
inline constexpr std::array kUntilNames = {"horizon", "next_goal", "half", "game"};

struct Question {
  Side own = Side::home;  // whose strategies these are
  Measure measure = Measure::goal_difference;
  Until until = Until::horizon;
  Tick horizon = ticks(30);  // [ticks]; kNever: none
  /// [unit of the measure] that another strategy must gain at least: so much is lost by changing in the middle of a game.
  float switching_cost = 0.02f;
  float sure = 0.9f;  // [0.5..1) how likely it must gain more than that
};

}  // namespace sim::foresight
