// The truth beside a robot's beliefs, and the sources of a feature's value.
#pragma once

#include <string>
#include <vector>

#include "sim/debug/decision.h"
#include "sim/match/params.h"
#include "sim/match/state.h"

namespace sim::debug {

/// Returns the beliefs of a robot that knows everything: where ball, teammates and opponents on the field are now.
agent::Beliefs true_beliefs(const State& state, int robot);

/// A part of the beliefs from which a value comes.
struct Source {
  enum class Kind { ball, pose, mate, opponent, memory, game };
  Kind kind = Kind::ball;
  int player = 0;   // number of the mate or the opponent; otherwise 0
  float age = -1;   // [s] since the sight or the message; -1: no age
  float error = 0;  // [m] distance from the truth; of a mate or an opponent off the field 0; NaN: truth unknown
};

/// Returns the parts that the value depends on in this decision: each changes the value when it alone is changed.
/// `state` is that of the decision's tick.
std::vector<Source> sources_of(agent::Feature feature, const Params& params, const agent::Tree& tree,
                               const Decision& decision, const State& state);

/// Returns "ball seen 0.3 s ago, 0.12 m off", without the last part if the truth is unknown.
std::string text_of(const Source& source);

}  // namespace sim::debug
