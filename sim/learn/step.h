// The common parts of the steps of learning: the place where they play, and their report.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "robot/core/json_library.h"
#include "sim/contest/series.h"
#include "sim/io/json.h"
#include "sim/learn/arena.h"
#include "sim/learn/change.h"
#include "sim/learn/seeds.h"

namespace sim::learn {

/// Says what a step does, with its share that is done [0..1].
using Tell = std::function<void(const std::string& activity, double done)>;

/// Where a step plays.
struct Practice {
  Arena& arena;
  Seeds& seeds;
  Tell tell;
  bool shuffled = false;  // the control run: each seed's scores are dealt to the strategies by chance

  /// Plays on new seeds of a purpose.
  robot::Result<std::vector<Scores>> play(const std::vector<io::Json>& strategies, Purpose purpose, int count) const;
  /// Plays on given seeds.
  robot::Result<std::vector<Scores>> play_on(const std::vector<io::Json>& strategies, std::uint64_t first,
                                             int count) const;
};

/// One generation of a curve.
struct CurvePoint {
  int generation = 0;
  double training = 0;  // gain of the best candidate on its own training seeds: too good
  double held_out = 0;  // gain of the mean over the start on seeds that chose nothing
  double error = 0;     // one standard error of `held_out`
};

/// The result of a step.
struct Learned {
  io::Json strategy;
  std::vector<Change> changes;     // empty: the strategy is the one before
  std::vector<std::string> notes;  // the attempts, a line each
  contest::Mean gain;              // of the changed strategy on the selection's seeds
  std::vector<CurvePoint> curve;
};

/// The number of standard deviations within which 95 % of a normal distribution lie.
inline constexpr double kSure = 1.96;

/// Returns whether a gain is above 0 with 95 % confidence, or with that of a number of tests together.
bool is_sure(const contest::Mean& gain, int tests = 1);

}  // namespace sim::learn
