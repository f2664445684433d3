// The starts of a drill: one situation per seed, drawn between the ends of the ranges.
#pragma once

#include "robot/core/result.h"
#include "sim/drills/drill.h"
#include "sim/match/params.h"
#include "sim/match/state.h"

namespace sim::drills {

/// The starts of a drill under the rules and models of a game. Any thread may draw from it.
class Starts {
 public:
  /// Reads both ends of the ranges. The Error names the drill and the place in it.
  static robot::Result<Starts> prepare(const Drill& drill, const Params& params);

  /// Returns the start of the game with that key, in play. Robots stand at least 0.4 m apart and 0.2 m from the ball, if
  /// one of 50 draws has such places. Allocates nothing.
  State draw(const Params& params, RandomKey key) const;

 private:
  State least_, most_;
  bool ball_known_ = true;
};

}  // namespace sim::drills
