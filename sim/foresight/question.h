// A question to foresight.
#pragma once

#include <array>

#include "sim/math/tick.h"
#include "sim/world/world.h"

namespace sim::foresight {

/// The measure of a rollout: a number that should be large.
enum class Measure : std::uint8_t {
  goal_difference,  // own goals minus the opponents', plus the value of the ball's place at the end
  score_next,       // 1 when the next goal is own
  concede,          // -1 when the next goal is the opponents'
};

/// The end of a rollout.
enum class Until : std::uint8_t {
  horizon,    // for Question::horizon of game time
  next_goal,  // to the next goal, or to the horizon if there is one
  half,       // to the end of the half
  game,
};

/// The names in text, by enumerator.
inline constexpr std::array kMeasureNames = {"goal_difference", "score_next", "concede"};
inline constexpr std::array kUntilNames = {"horizon", "next_goal", "half", "game"};

/// One question.
struct Question {
  Side own = Side::home;  // the side of the strategies
  Measure measure = Measure::goal_difference;
  Until until = Until::horizon;
  Tick horizon = ticks(30);  // [ticks]; kNever: none
  /// [unit of the measure] Least gain of another strategy: the loss by a change during the game.
  float switching_cost = 0.02f;
  float sure = 0.9f;  // [0.5..1) probability that the gain must exceed this cost
};

}  // namespace sim::foresight
