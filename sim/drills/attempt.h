// One attempt at a drill, or one game: its end and its score, tick by tick.
#pragma once

#include <vector>

#include "sim/check/condition.h"
#include "sim/check/glance.h"
#include "sim/drills/drill.h"

namespace sim::drills {

enum class Outcome : std::uint8_t { running, success, failure, time_over };

/// The judge of one attempt. Neither drill nor start are copied.
class Attempt {
 public:
  /// `drill` and `start` outlive the attempt.
  Attempt(const Drill& drill, const State& start);
  Attempt(const Attempt&) = delete;
  Attempt& operator=(const Attempt&) = delete;

  /// Judges the state after a step. Call once after each step until the outcome is known. A game that ends without
  /// success is a failure. `time_over` means that the time was over before either.
  Outcome see(const State& now, const referee::Events& events);

  /// Returns the points of the last tick.
  float points() const { return points_; }
  /// Returns the points so far.
  float score() const { return score_; }
  /// Returns whether an attempt with this outcome has succeeded. For time_over the drill decides.
  bool succeeded(Outcome outcome) const;

 private:
  Outcome outcome_of(const State& now) const;
  float points_in(const check::Glance& glance, Outcome outcome);

  const Drill& drill_;
  const State& start_;
  check::Observer observer_;
  check::Watch success_, failure_;
  std::vector<bool> held_;       // by Drill::score: the fact held in the last tick
  std::vector<float> quantity_;  // by Drill::progress: in the last tick; NaN: unknown
  float points_ = 0, score_ = 0;
};

}  // namespace sim::drills
