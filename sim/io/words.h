// Helping whoever mistyped a word.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace sim::io {

/// "; did you mean 'ball_age'?" if one of `known` is near to `word`, else "; there are: …" of few or "" of many.
std::string hint(std::string_view word, const std::vector<std::string_view>& known);

}  // namespace sim::io
