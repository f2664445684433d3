// The numbers of a layer, tuned by CMA-ES.
#pragma once

#include "sim/learn/layer.h"
#include "sim/learn/step.h"

namespace sim::learn {

struct TuningPlan {
  int generations = 20;
  int attempts = 100;   // seeds of a candidate in a generation, which all candidates share
  int selection = 400;  // seeds of the round that chooses among the last candidates
  int test = 3000;      // seeds of the test of the choice, which only two or three strategies play
};

/// Tunes the knobs of the layer that make a difference in its exercises. Numbers whose change is worth nothing keep their
/// values. The result is `strategy` itself unless the new values win the second round, whose seeds
/// chose nothing, with 95 % confidence.
robot::Result<Learned> tune(const io::Json& strategy, const Layer& layer, const TuningPlan& plan, std::uint64_t seed,
                            const Practice& practice);

}  // namespace sim::learn
