// 2025: the penalty shoot-out of a drawn game. The sides shoot in turn, Rules::shoot_out_shots each. It ends as soon as a
// side cannot catch up. At a draw follows the sudden death: the first pair of shots with different results decides, of at
// most Rules::shoot_out_sudden_shots pairs. GameController: action WaitForPenaltyShot.
#pragma once

#include <optional>

#include "sim/field/rules.h"
#include "sim/world/world.h"

namespace sim::referee::shoot_out {

/// The shots so far. Pairs are by Side.
struct Tally {
  Side first = Side::home;  // side that shoots first
  int shots[2] = {0, 0};
  int goals[2] = {0, 0};
};

/// Returns the side of the next shot, or nothing when the shoot-out is over.
inline std::optional<Side> next(const field::Rules& rules, const Tally& tally) {
  const auto first = static_cast<int>(tally.first), second = 1 - first;
  const int shooter = tally.shots[first] > tally.shots[second] ? second : first, last = 1 - shooter;
  const int left = rules.shoot_out_shots - tally.shots[shooter],
            left_for_last = rules.shoot_out_shots - tally.shots[last];
  const int lead = tally.goals[last] - tally.goals[shooter];
  const bool goes_on = left > 0 ? lead <= left && -lead <= left_for_last
                                : left > -rules.shoot_out_sudden_shots && (shooter == second || lead == 0);
  if (!goes_on) return {};
  return static_cast<Side>(shooter);
}

/// Returns the side with more goals, or nothing at a draw: then the referee decides by other criteria.
inline std::optional<Side> winner(const Tally& tally) {
  if (tally.goals[0] == tally.goals[1]) return {};
  return tally.goals[0] > tally.goals[1] ? Side::home : Side::away;
}

}  // namespace sim::referee::shoot_out
