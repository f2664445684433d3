// JSON from outside: what clients ask, what other robots answer, what people write into files.
#pragma once

#include <nlohmann/json.hpp>
#include <string_view>

#include "robot/core/result.h"

namespace robot {

/// Lists and objects within each other, the outermost included. The library copies, prints and forgets a value by calling
/// itself for what is inside, so that a hundred thousand brackets, 200 kB, would end the process.
inline constexpr int kDeepestJson = 64;

/// What the text says. An Error, "expected JSON, got something else", where it is none, and where it is nested deeper
/// than kDeepestJson.
Result<nlohmann::json> parse_json(std::string_view text);

}  // namespace robot
