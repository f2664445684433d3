// JSON from outside: requests of clients, answers of other robots, files that people write.
#pragma once

#include <cstddef>
#include <cstdint>
#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>
#include <string_view>

#include "robot/core/result.h"

namespace robot {

/// The greatest number of lists and objects within each other, the outermost included. The library copies, prints and
/// frees a value by recursion, so a text of a hundred thousand brackets (200 kB) would end the process.
inline constexpr int kDeepestJson = 64;

/// Returns the value that `text` describes. Returns the Error "expected JSON, got something else" if the text is not
/// JSON, and an Error if it is nested deeper than kDeepestJson.
Result<nlohmann::json> parse_json(std::string_view text);

/// Returns the value for an error sentence: as JSON in ASCII, of more than `most` bytes the first ones and "…".
std::string shown(const nlohmann::json& value, std::size_t most = 60);

/// Returns the whole number that `value` is, in any spelling: 1, 1.0 and 1e0 are the same. Returns nothing for 1.5, for a
/// text and other values, and for a number that such a spelling cannot hold exactly (above 2^53) or an int64 cannot hold.
std::optional<std::int64_t> whole_number(const nlohmann::json& value);

/// Returns the number that the decimal text `object[key]` spells, or nothing for anything else. 64-bit numbers are texts
/// in JSON, because the numbers of JavaScript hold 53 bits. T: std::int64_t or std::uint64_t.
template <class T>
std::optional<T> number_in_text(const nlohmann::json& object, const char* key);

}  // namespace robot
