// The effect of a change: the same moment played on many times with and without it, with the same luck.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "sim/debug/setup.h"
#include "sim/debug/timeline.h"
#include "sim/match/state.h"

namespace sim::debug {

/// A moment, and the game that is played on from it.
struct Moment {
  SharedSetup setup;
  State state;
  // in which behaviours from outside are brought to the moment; nullptr: there are none
  std::shared_ptr<const Timeline> past = nullptr;
};

/// The same moment without and with a change, at the same tick.
struct Pair {
  Moment without, with;
};

/// The path of one future until the next goal or the end. Frame: field.
struct FuturePath {
  static constexpr Tick kSpacing = 15;  // [ticks] between two points
  std::vector<Vec2> ball;               // [m]
  std::vector<Vec2> robot;              // [m] of the robot for which the futures are played, until it is sent off
};

/// The mean of a difference in pairs, with its 95 % interval.
struct Effect {
  double without = 0, with = 0;  // means
  double low = 0, high = 0;      // interval of the mean of with - without
};

/// The futures of a moment with and without a change.
struct Futures {
  int count = 0;                // pairs
  Tick begin = 0;               // of the first pair
  int different = 0;            // pairs in which anything differs after the first tick
  Effect scores;                // share of futures in which the side scores
  Effect concedes;              // in which it concedes
  Effect goals;                 // goal difference
  std::optional<Tick> parting;  // of the pair with the game's own luck: first tick behind the moment with a difference
  std::string field;            // its first field that differs there
  // of the first kPaths pairs:
  std::vector<FuturePath> paths_without, paths_with;
  static constexpr int kPaths = 12;
};

/// Plays at least two pairs of futures of `length` [ticks]. Pair 0 has the luck of its game, each other pair a luck of its
/// own. The goals are counted for the side of `robot`.
Futures futures(const std::vector<Pair>& pairs, int robot, Tick length);

/// Returns the table of three lines, and the sentence about the parting.
std::string text_of(const Futures& futures, Tick length);

}  // namespace sim::debug
