// The words of a command line.
#pragma once

#include <charconv>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "robot/core/result.h"
#include "sim/field/field.h"
#include "sim/math/vec2.h"

namespace sim::debug {

/// Returns the words between blanks.
std::vector<std::string> words_of(std::string_view line);

/// Returns the words from that index on, with a blank between them.
std::string rest_of(const std::vector<std::string>& words, std::size_t from);

/// Returns the number if the text is one and nothing more.
template <class Number>
std::optional<Number> number_in(std::string_view text) {
  Number number{};
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
  if (error != std::errc{} || end != text.data() + text.size()) return {};
  return number;
}

/// Reads "X Y" on the field and the ground around it [m].
robot::Result<Vec2> place_in(const std::vector<std::string>& words, std::size_t at, const field::Field& field);

/// Reads the heading [deg] behind a place, if there is one, and returns it in rad.
robot::Result<std::optional<float>> heading_in(const std::vector<std::string>& words, std::size_t at);

}  // namespace sim::debug
