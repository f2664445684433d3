// Conditions of a strategy: "role is chaser and ball_distance < 0.35 m", "not mates_time_to_ball < time_to_ball".
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "robot/core/result.h"
#include "sim/agent/tree.h"
#include "sim/io/values.h"

namespace sim::io {

/// One comparison.
struct Term {
  agent::Feature feature;
  agent::Comparison comparison;
  float threshold;
  std::string text;                          // as written
  agent::Feature other = agent::kNoFeature;  // unless kNoFeature: compared instead of `threshold`
};

/// A condition: it holds if all terms of one alternative hold. No alternative is empty.
struct Condition {
  std::vector<std::vector<Term>> alternatives;
};

inline constexpr std::size_t kMaxConditionBytes = 1000;

/// Returns the comparison as text, which parse_condition reads back identically: "ball_distance < 0.35 m".
std::string text_of(const Term& term);

/// Returns the comparison with this text for its threshold.
std::string text_of(const Term& term, const std::string& threshold);

/// Parses a condition. The Error is the end of a sentence that begins with the place of the condition.
robot::Result<Condition> parse_condition(std::string_view text, Values& values);

}  // namespace sim::io
