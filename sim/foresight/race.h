// The race: several strategies play on from one situation as long as the budget lasts.
#pragma once

#include <cstdint>
#include <functional>

#include "sim/foresight/outlook.h"
#include "sim/foresight/question.h"
#include "sim/foresight/rollout_statistics.h"
#include "sim/foresight/situation.h"

namespace sim::foresight {

/// The complete input of a race. All pointers outlive it.
struct Task {
  const Situation* situation = nullptr;
  int strategies = 0;  // 1 .. kMaxStrategies; the first is the incumbent, with which the others are compared
  const Params* params[kMaxStrategies] = {};  // they differ only in the behaviour of the asking side
  Question question;
  const Outlook* outlook = nullptr;  // for rollouts that end before the game; nullptr: the ball's place has the value 0
  RandomKey key;                     // stripe j plays with the j-th key after it
};

/// Returns the spent share of the budget: 0 nothing, 1 or more all. Called with the number of rollouts that are complete,
/// before those of each strategy, at intervals within them, and after each stripe.
using Spent = std::function<double(std::int64_t rollouts)>;
/// Receives the statistics after each stripe.
using Told = std::function<void(const RolloutStatistics&)>;

inline constexpr int kFewestStripes = 8;  // fewer give no estimate of chance

/// Runs the race by sequential halving (Karnin, Koren, Somekh, ICML 2013): rounds with equal shares of the budget.
/// After each round the better half goes on, and always the incumbent. Stripes are played side by side, fewer towards the
/// end of the budget. Those that it cuts off do not count. Allocates nothing; needs 0.3 MB of the stack.
void race(const Task& task, const Spent& spent, const Told& told, RolloutStatistics& statistics);

}  // namespace sim::foresight
