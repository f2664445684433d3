// The JSON of descriptions: objects keep the order of their keys, and no key occurs twice.
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>
#include <string_view>

#include "robot/core/result.h"

namespace sim::io {

using Json = nlohmann::ordered_json;

/// Parses the object in `text`. `called` opens the sentence of an Error, which has line and column.
robot::Result<Json> parse_object(std::string_view text, const std::string& called);

/// Returns the JSON as text, indented by two spaces.
std::string printed(const Json& json);

/// Returns a value for the sentence of an Error, shortened when long.
std::string shown(const Json& json);

/// Returns text from a file in double quotes, for an error sentence; shortened as by shown().
std::string quoted(std::string_view text);

/// Returns the number with the fewest digits that distinguish `value` from every other float.
double short_number(float value);
std::string short_text(float value);

}  // namespace sim::io
