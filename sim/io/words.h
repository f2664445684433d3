// Hints for mistyped words.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace sim::io {

/// Returns "; did you mean 'ball_age'?" if one of `known` is similar, otherwise ";
/// there are: …" for few or "" for many.
std::string hint(std::string_view word, const std::vector<std::string_view>& known);

}  // namespace sim::io
