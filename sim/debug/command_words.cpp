#include "sim/debug/command_words.h"

#include <algorithm>

#include "robot/core/text.h"
#include "sim/io/values.h"
#include "sim/math/angles.h"

namespace sim::debug {

using robot::Error;
using robot::Result;

namespace {

Result<float> number(const std::string& text, float least, float most, const char* unit) {
  const auto value = io::Values().read(std::string_view(text), {unit, least, most, nullptr});
  if (!value) return Error{value.error()};
  return *value;
}

}  // namespace

std::vector<std::string> words_of(std::string_view line) {
  std::vector<std::string> words;
  while (true) {
    const std::size_t begin = line.find_first_not_of(" \t\r\n");
    if (begin == line.npos) return words;
    line.remove_prefix(begin);
    const std::size_t end = std::min(line.find_first_of(" \t\r\n"), line.size());
    words.emplace_back(line.substr(0, end));
    line.remove_prefix(end);
  }
}

std::string rest_of(const std::vector<std::string>& words, std::size_t from) {
  const auto first = words.begin() + static_cast<std::ptrdiff_t>(std::min(from, words.size()));
  return robot::joined({first, words.end()}, " ");
}

Result<Vec2> place_in(const std::vector<std::string>& words, std::size_t at, const field::Field& field) {
  if (words.size() < at + 2) return Error{"expected X and Y [m], got '" + rest_of(words, at) + "'"};
  const auto x = number(words[at], -field.length / 2 - field.border, field.length / 2 + field.border, "m");
  if (!x) return Error{"X " + x.error()};
  const auto y = number(words[at + 1], -field.width / 2 - field.border, field.width / 2 + field.border, "m");
  if (!y) return Error{"Y " + y.error()};
  return Vec2{*x, *y};
}

Result<std::optional<float>> heading_in(const std::vector<std::string>& words, std::size_t at) {
  if (words.size() <= at) return std::optional<float>{};
  const auto degrees = number(words[at], -180, 180, "");
  if (!degrees) return Error{"the heading in degrees " + degrees.error()};
  return std::optional(*degrees * kPi / 180);
}

}  // namespace sim::debug
