// The structure of a layer: other actions for a leaf, leaves that are split, branches that are removed.
#pragma once

#include "sim/learn/layer.h"
#include "sim/learn/step.h"

namespace sim::learn {

struct GrowingPlan {
  int attempts = 300;   // seeds on which each (leaf, action) is played
  int selection = 600;  // seeds of the test of each change
  int most = 6;         // changes that are tested
};

/// Learns the value of each (leaf, action) from exploring starts: the same attempt with the leaf's own action and with
/// another one is the same up to the first visit of the leaf, so the difference of their scores is what the action is
/// worth there. A condition on the features of that moment, or none, is added where it gains most, if a test on other
/// seeds confirms it; the confidence is shared among the tests of a layer. A rule whose removal costs nothing goes.
robot::Result<Learned> grow(const io::Json& strategy, const Layer& layer, const GrowingPlan& plan,
                            const Practice& practice);

}  // namespace sim::learn
