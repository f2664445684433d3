// Several strategies play on from one situation, as long as the budget lasts.
#pragma once

#include <cstdint>
#include <functional>

#include "sim/foresight/outlook.h"
#include "sim/foresight/question.h"
#include "sim/foresight/rollout_statistics.h"
#include "sim/foresight/situation.h"

namespace sim::foresight {

/// All that a race follows from. What is pointed to outlives it.
struct Task {
  const Situation* situation = nullptr;
  int strategies = 0;  // 1 .. kMaxStrategies; the first is the incumbent: the others are measured by it
  const Params* params[kMaxStrategies] = {};  // they differ in the behaviour of the asking side alone
  Question question;
  const Outlook* outlook = nullptr;  // for rollouts that end before the game does; nullptr: the ball's place is worth 0
  RandomKey key;                     // stripe j plays with the j-th key after it
};

/// How much of the budget is spent: 0 nothing, 1 or more all. Asked before each rollout and now and then within one,
/// with the number of rollouts so far.
using Spent = std::function<double(std::int64_t rollouts)>;
/// Hears the statistics after each stripe.
using Told = std::function<void(const RolloutStatistics&)>;

inline constexpr int kFewestStripes = 8;  // fewer say nothing about chance

/// Sequential halving (Karnin, Koren, Somekh, ICML 2013): as many rounds as halvings leave one, each an equal share of the
/// budget; after each the better half goes on, the incumbent always. A stripe that the end of the budget cuts in two does
/// not count. Allocates nothing.
void race(const Task& task, const Spent& spent, const Told& told, RolloutStatistics& statistics);

}  // namespace sim::foresight
