// What the rollouts of a question came to so far: sums, so that any moment has its answer.
#pragma once

#include <cstdint>

#include "sim/math/vec2.h"
#include "sim/world/world.h"

namespace sim::foresight {

inline constexpr int kMaxStrategies = 8;

/// Where the ball was, over all rollouts of a strategy: once a second, on a grid over the field. Frame: field,
/// as the sides stand at the beginning; so are paths.
struct HeatMap {
  static constexpr int kColumns = 18, kRows = 12;  // along x from -length / 2, along y from -width / 2
  std::uint32_t counts[kRows][kColumns] = {};
};

/// One continuation, seen from above. Frame: field, of the beginning.
struct Path {
  static constexpr int kPoints = 31;
  int points = 0;
  float spacing = 0;                  // [s] from one point to the next
  Vec2 ball[kPoints];                 // [m]
  Vec2 robots[kPoints][kMaxPlayers];  // [m] of one's own side, by number
};

/// One strategy's rollouts.
struct StrategyStatistics {
  static constexpr int kPaths = 3;  // of the first stripes: as good as any, and the same luck for every strategy
  bool racing = true;               // false: the race went on without it
  int rollouts = 0;
  double sum = 0, squares = 0;   // of the measure
  int scored = 0, conceded = 0;  // rollouts whose first goal was one's own, the others'
  HeatMap heat;
  Path paths[kPaths];
};

/// Plain data: copied to whoever asks while the race goes on.
///
/// A stripe is one possible world and one set of random numbers, played with every strategy that still races. So two
/// strategies have all stripes in common that the one which left first has.
struct RolloutStatistics {
  int strategies = 0;
  int stripes = 0;         // of the strategies that still race; the first strategy, the incumbent, always does
  double spent = 0;        // [0..1] of the budget
  std::int64_t ticks = 0;  // of game time played
  StrategyStatistics by_strategy[kMaxStrategies];
  /// A gain is a strategy's value less the incumbent's in the same stripe. Over the stripes that both i and j played:
  /// the sum of i's gains, and that of i's gain times j's.
  double gains[kMaxStrategies][kMaxStrategies] = {};
  double products[kMaxStrategies][kMaxStrategies] = {};
};

}  // namespace sim::foresight
