// The answers of the debugger as text.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "robot/core/result.h"
#include "sim/debug/belief_change.h"
#include "sim/debug/why.h"
#include "sim/debug/why_not.h"

namespace sim::debug {

/// Returns the leaves of a skill, of a part of the tree by its path, or below a name of the tree. The Error names a similar
/// skill.
robot::Result<Goal> goal_of(const std::string& text, const agent::Tree& tree);

/// The whole answer to "why not?".
struct Alternative {
  WhyNot features;
  // the ways to change the tree or the beliefs; absent if there is none, or if the decision reaches the goal as it is
  std::optional<std::vector<NewThreshold>> thresholds;
  std::optional<BeliefChange> beliefs;
};

/// Searches for it. Returns an Error if the robot did not play, and so asked its tree nothing. `name` is that of the robot.
robot::Result<Alternative> alternative_to(const Params& params, const agent::Tree& tree, const Decision& decision,
                                          const Goal& goal, const std::string& name);

/// Returns the answer as text. `what` is the asked skill or leaf.
std::string text_of(const Alternative& answer, const agent::Tree& tree, const std::string& name,
                    const std::string& what);
/// Returns the nearest value as a bound, because it lies at the edge of what is needed: "at most 0.35 m".
std::string bound_text(const NewValue& change);

/// Returns the place of a state in its game: "at 812.30 s, half 2, 3:12 on the clock, 1:0, playing".
std::string place_text(const State& state);
/// Returns ball and robots, with the errors of their beliefs. `name` names a robot by its index.
std::string show_text(const Params& params, const State& state, const std::function<std::string(int)>& name);

}  // namespace sim::debug
