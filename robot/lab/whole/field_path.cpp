#include "robot/lab/whole/field_path.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <optional>

namespace robot::lab {
namespace {

constexpr std::size_t kMostSteps = 16;

template <class T>
std::optional<T> number_of(std::string_view text) {
  T value{};
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc() || end != text.data() + text.size()) return std::nullopt;
  return value;
}

/// Parses "team=14,player=2".
std::optional<EntryFilter> filter_of(std::string_view text) {
  EntryFilter filter;
  while (true) {
    const std::string_view part = text.substr(0, text.find(','));
    const std::size_t equals = part.find('=');
    if (equals == part.npos || equals == 0) return std::nullopt;
    const auto wanted = number_of<double>(part.substr(equals + 1));
    if (!wanted || !std::isfinite(*wanted)) return std::nullopt;
    filter.emplace_back(part.substr(0, equals), *wanted);
    if (part.size() == text.size()) return filter;
    text.remove_prefix(part.size() + 1);
  }
}

}  // namespace

Result<FieldPath> parse_field_path(std::string_view text) {
  const Error wrong{"expected a field such as x, robots[0].y or robots[player=2].y, got '" +
                    std::string(text.substr(0, 100)) + "'"};
  FieldPath path;
  std::string_view rest = text;
  bool named = true;  // a name must or may come next
  while (!rest.empty()) {
    if (rest.front() == '[') {
      const std::size_t end = rest.find(']');
      if (path.empty() || named || end == rest.npos) return wrong;
      const std::string_view inner = rest.substr(1, end - 1);
      if (const auto index = number_of<std::size_t>(inner))
        path.emplace_back(*index);
      else if (auto filter = filter_of(inner))
        path.emplace_back(std::move(*filter));
      else
        return wrong;
      rest.remove_prefix(end + 1);
    } else if (named) {
      const std::size_t end = std::min(rest.find_first_of(".[]"), rest.size());
      if (end == 0) return wrong;
      path.emplace_back(std::string(rest.substr(0, end)));
      rest.remove_prefix(end);
      named = false;
    } else if (rest.front() == '.') {
      rest.remove_prefix(1);
      named = true;
    } else {
      return wrong;
    }
    if (path.size() > kMostSteps) return wrong;
  }
  if (path.empty() || named) return wrong;
  return path;
}

}  // namespace robot::lab
