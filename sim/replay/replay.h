// A recorded game in the simulator: one side moves as recorded, the other plays.
#pragma once

#include <array>

#include "sim/match/params.h"
#include "sim/match/state.h"
#include "sim/replay/track.h"

namespace sim::replay {

/// The positions of a recorded game. Frame: field.
struct Recording {
  Track ball;
  std::array<Track, kMaxRobots> robots;  // by index in the simulator; empty: not in the recording
  Tick length = 0;                       // [ticks] tick of the last data
  int half = 1;                          // in which the recording is; the home side attacks +x in odd halves
};

/// A stretch of a recording that is played again. The robots of the recorded sides are carried along their tracks: they
/// collide with robots and ball, but they do not kick, and the referee has no power over them. If both sides are
/// recorded, the ball is, too. The others play from their recorded places.
class Replay {
 public:
  /// Begins at tick `from` of the recording, which outlives the replay. `recorded` is by Side.
  Replay(const Recording& recording, Tick from, std::array<bool, 2> recorded)
      : recording_(recording), from_(from), recorded_(recorded) {}

  /// Returns the state at the beginning, in play. Robots without data then do not play.
  State begin(const Params& params, RandomKey key);

  /// Puts everything recorded in its place at the present tick. Called after each step.
  void place(const Params& params, State& state);

  bool is_recorded(int robot) const { return recorded_[static_cast<std::size_t>(side_of(robot))]; }

  /// The time [ticks] in which a recorded robot had no data: it stood still, then it was absent.
  struct Missing {
    Tick held = 0, absent = 0;
  };
  const Missing& missing(int robot) const { return missing_[static_cast<std::size_t>(robot)]; }

 private:
  void place_robot(const Params& params, State& state, int robot);
  void place_ball(State& state) const;

  const Recording& recording_;
  const Tick from_;
  const std::array<bool, 2> recorded_;
  std::array<Missing, kMaxRobots> missing_ = {};
};

}  // namespace sim::replay
