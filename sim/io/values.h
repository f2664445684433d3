// The values in conditions and arguments of a strategy.
#pragma once

#include <set>
#include <string>
#include <string_view>

#include "robot/core/result.h"
#include "sim/agent/features.h"
#include "sim/agent/settings.h"
#include "sim/agent/skills.h"
#include "sim/io/json.h"

namespace sim::io {

/// The expected value.
struct Expected {
  const char* unit;  // "" without a unit
  float least;
  float most;
  const char* const* names;  // the words for 0, 1, …, ended by nullptr; nullptr: a number
  // Takes other words than `names`, as names of kicks: a word's value is its place in the list, after those of `names`.
  agent::NamedKicks* kicks = nullptr;
};

/// Returns what a leaf may give for that parameter. `kicks`: the kicks that it may name, if the parameter names kicks.
Expected expected_of(const agent::ParameterInfo& info, agent::NamedKicks* kicks = nullptr);
/// Returns what a feature may be compared with.
Expected expected_of(const agent::FeatureInfo& info);

/// Returns the value as Values reads it: "0.35 m", "2", "goal".
std::string value_text(float value, const Expected& expected);

/// A reader of values. It resolves "$name" to the parameters and records the used ones.
class Values {
 public:
  /// Knows no "$name".
  Values();
  /// `parameters` outlives it.
  explicit Values(const Json& parameters) : parameters_(parameters) {}

  /// Reads a value: 0.35, "0.35 m", "20 deg", "goal", "$near". The Error is the end of a
  /// sentence: "must be 0 .. 3 [m], got 7".
  robot::Result<float> read(const Json& value, const Expected& expected);
  robot::Result<float> read(std::string_view text, const Expected& expected);

  const std::set<std::string, std::less<>>& used() const { return used_; }

 private:
  const Json& parameters_;
  std::set<std::string, std::less<>> used_;
};

}  // namespace sim::io
