// Hints for mistyped words.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace sim::io {

/// Returns the number of letters to insert, to remove, to replace, or to exchange with their neighbour, until `a` is
/// `b`.
std::size_t edits_between(std::string_view a, std::string_view b);

/// Returns "; did you mean 'ball_age'?" or "; did you mean 'x' or 'y'?": the most similar ones of `known`, at most
/// three. Returns "" if none is similar.
std::string did_you_mean(std::string_view word, const std::vector<std::string_view>& known);

/// Returns did_you_mean() if one of `known` is similar, otherwise "; there are: …" for few or "" for many.
std::string hint(std::string_view word, const std::vector<std::string_view>& known);

}  // namespace sim::io
