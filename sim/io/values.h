// The values that conditions and arguments of a strategy are written with.
#pragma once

#include <set>
#include <string>
#include <string_view>

#include "robot/core/result.h"
#include "sim/io/json.h"

namespace sim::io {

/// What a value must be.
struct Expected {
  const char* unit;  // "" where there is none
  float least;
  float most;
  const char* const* names;  // the words for 0.., ended by nullptr; nullptr: it is a number
};

/// Reads values, following "$name" to the parameters, and notes which of these were used.
class Values {
 public:
  /// `parameters` outlives it.
  explicit Values(const Json& parameters) : parameters_(parameters) {}

  /// 0.35, "0.35 m", "20 deg", "goal", "$near". The Error is the end of a sentence: "must be 0 .. 3 [m], got 7".
  robot::Result<float> read(const Json& value, const Expected& expected);
  robot::Result<float> read(std::string_view text, const Expected& expected);

  const std::set<std::string, std::less<>>& used() const { return used_; }

 private:
  const Json& parameters_;
  std::set<std::string, std::less<>> used_;
};

}  // namespace sim::io
