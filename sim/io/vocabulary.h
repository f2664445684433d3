// The words of a strategy: all skills and features, as the parser of strategies knows them.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "robot/core/result.h"
#include "sim/agent/features.h"
#include "sim/agent/skills.h"
#include "sim/io/json.h"

namespace sim::io {

/// Returns the names of all features, in the order of their ids.
std::vector<std::string_view> all_features();

/// Find a word. The Error for an unknown one has the most similar words, or all of them if they are few.
robot::Result<agent::Skill> skill_named(std::string_view name);
robot::Result<agent::Feature> feature_named(std::string_view name);

/// Returns a rule with all arguments at their defaults, as JSON in one line. It is a whole tree of a strategy.
std::string example_of(agent::Skill skill);
/// Returns a condition that compares the feature: "ball_distance < 0.5 m", "ball_known", "role is keeper".
std::string example_of(agent::Feature feature);

/// Describe a word for programs: its name, meaning and example; units, ranges and defaults of values and arguments.
Json json_of(agent::Skill skill);
Json json_of(agent::Feature feature);

/// Describes a skill for people: a line with its meaning, one per argument, and the example.
std::string text_of(agent::Skill skill);
/// Describes a feature for people in one line: name, range, example, meaning. A star behind the name marks a feature
/// that is unknown while the ball is.
std::string text_of(agent::Feature feature);

}  // namespace sim::io
