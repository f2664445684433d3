// The answers of the debugger as text.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "sim/debug/belief_change.h"
#include "sim/debug/why.h"
#include "sim/debug/why_not.h"

namespace sim::debug {

/// Returns the answer to "why not?": features, thresholds and beliefs. `what` is the asked skill or leaf.
std::string text_of(const WhyNot& answer, const std::optional<std::vector<NewThreshold>>& thresholds,
                    const std::optional<BeliefChange>& beliefs, const agent::Tree& tree, const std::string& name,
                    const std::string& what);

/// Returns the place of a state in its game: "at 812.30 s, half 2, 3:12 on the clock, 1:0, playing".
std::string place_text(const State& state);
/// Returns ball and robots, with the errors of their beliefs. `name` names a robot by its index.
std::string show_text(const Params& params, const State& state, const std::function<std::string(int)>& name);

}  // namespace sim::debug
