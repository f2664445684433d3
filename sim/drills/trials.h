// Many attempts at a drill, and the share that succeeds.
#pragma once

#include <cstdint>
#include <functional>
#include <span>
#include <string>

#include "robot/core/result.h"
#include "sim/check/findings.h"
#include "sim/contest/lineup.h"
#include "sim/contest/series.h"
#include "sim/drills/attempt.h"
#include "sim/drills/starts.h"

namespace sim::drills {

struct TrialOptions {
  std::string strategy;  // of the home side; empty: by the drill
  std::string against;   // of the away side; empty: by the drill
  int trials = 400;
  std::uint64_t seed = 1;  // of the first attempt; the others have the next ones
};

/// The end of one attempt.
struct Ended {
  Outcome outcome = Outcome::running;
  bool succeeded = false;  // by the drill
  float score = 0;
  float seconds = 0;
};

/// Plays one attempt for each element of `ended`, side by side; attempt i has the seed `first_seed` + i. The behaviours
/// of `params` must be trees, which games can share.
void play_attempts(const Drill& drill, const Starts& starts, const Params& params, std::uint64_t first_seed,
                   std::span<Ended> ended);

/// The results of all attempts.
struct Trials {
  int trials = 0;
  int successes = 0, failures = 0, times_over = 0;  // by outcome; an attempt whose time is over may be a success
  int succeeded = 0;                                // by the drill
  check::Interval interval;                         // 95 % of the share that succeeds
  contest::Mean score;                              // of an attempt
  contest::Mean seconds;                            // [s] of the attempts that succeeded

  double share() const { return static_cast<double>(succeeded) / trials; }
};

/// Plays the attempts. The result depends on drill and options only. Calls `progress` with the number of finished ones.
robot::Result<Trials> run_trials(const Drill& drill, const TrialOptions& options,
                                 const std::function<void(int)>& progress = {});

}  // namespace sim::drills
