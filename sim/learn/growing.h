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

/// Learns the value of each (leaf, action) from exploring starts. An attempt with the leaf's own action and the same one
/// with another action are equal up to the first visit of the leaf. So the difference of their scores is the worth of the
/// action in that moment.
///
/// Each leaf may get another action, with a condition on the features of that moment or without. The change that promises
/// most is kept if a test on other seeds confirms it. The tests of a layer share their confidence. A rule whose removal
/// costs nothing goes.
robot::Result<Learned> grow(const io::Json& strategy, const Layer& layer, const GrowingPlan& plan,
                            const Practice& practice);

}  // namespace sim::learn
