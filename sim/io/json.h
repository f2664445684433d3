// JSON as descriptions are written in: objects keep the order of their keys, and no key stands twice.
#pragma once

#include <nlohmann/json.hpp>
#include <string>
#include <string_view>

#include "robot/core/result.h"

namespace sim::io {

using Json = nlohmann::ordered_json;

/// The object in `text`. `called` opens the sentence of an Error, which tells line and column.
robot::Result<Json> parse_object(std::string_view text, const std::string& called);

/// As text for people: two spaces deep.
std::string printed(const Json& json);

/// A value in the sentence of an Error, cut where it is long.
std::string shown(const Json& json);

/// The number that is printed with as few digits as tell `value` from every other float.
double short_number(float value);
std::string short_text(float value);

}  // namespace sim::io
