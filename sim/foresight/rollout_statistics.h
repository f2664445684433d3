// The sums over the rollouts of a question: an answer is possible at any time.
#pragma once

#include <cstdint>

#include "sim/math/vec2.h"
#include "sim/world/world.h"

namespace sim::foresight {

inline constexpr int kMaxStrategies = 8;

/// Counts of the ball's place over all rollouts of a strategy, once a second, on a grid. Frame: field, with the sides
/// as at the beginning; the same for paths.
struct HeatMap {
  static constexpr int kColumns = 18, kRows = 12;  // along x from -length / 2, along y from -width / 2
  std::uint32_t counts[kRows][kColumns] = {};
};

/// The paths of ball and robots in one rollout. Frame: field of the beginning.
struct Path {
  static constexpr int kPoints = 31;
  int points = 0;
  float spacing = 0;                  // [s] from one point to the next
  Vec2 ball[kPoints];                 // [m]
  Vec2 robots[kPoints][kMaxPlayers];  // [m] of the own side, by number
};

/// The sums over one strategy's rollouts.
struct StrategyStatistics {
  static constexpr int kPaths = 3;  // of the first stripes: the same luck for every strategy
  bool racing = true;               // false: dropped from the race
  int rollouts = 0;
  double sum = 0, squares = 0;   // of the measure
  int scored = 0, conceded = 0;  // rollouts whose first goal was own, the opponents'
  HeatMap heat;
  Path paths[kPaths];
};

/// The sums of a race. Plain data: copied to readers while the race goes on.
///
/// A stripe is one possible world and one set of random numbers, played with every strategy that still races. Two
/// strategies therefore share all stripes of the one that left first.
struct RolloutStatistics {
  int strategies = 0;
  int stripes = 0;         // of the strategies that still race; the first strategy, the incumbent, always does
  double spent = 0;        // [0..1] of the budget
  std::int64_t ticks = 0;  // of game time played
  StrategyStatistics by_strategy[kMaxStrategies];
  /// A gain is a strategy's value minus the incumbent's in the same stripe. Over the stripes that both i and j played:
  /// the sum of i's gains, and of i's gain times j's.
  double gains[kMaxStrategies][kMaxStrategies] = {};
  double products[kMaxStrategies][kMaxStrategies] = {};
};

}  // namespace sim::foresight
