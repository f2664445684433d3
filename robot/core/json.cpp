#include "robot/core/json.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <string>

#include "robot/core/json_library.h"

template class nlohmann::basic_json<>;
template class nlohmann::basic_json<nlohmann::ordered_map>;

namespace robot {
namespace {

/// Returns the greatest number of open brackets. It is exact for JSON; for other text the result does not matter.
int depth_of(std::string_view text) {
  int depth = 0, deepest = 0;
  bool in_text = false;
  for (std::size_t i = 0; i < text.size(); ++i) {
    const char c = text[i];
    if (in_text && c == '\\')
      ++i;  // an escaped quote ends no text
    else if (c == '"')
      in_text = !in_text;
    else if (!in_text && (c == '[' || c == '{'))
      deepest = std::max(deepest, ++depth);
    else if (!in_text && (c == ']' || c == '}'))
      --depth;
  }
  return deepest;
}

}  // namespace

Result<nlohmann::json> parse_json(std::string_view text) {
  // checked before parsing: a value that is too deep could not be freed safely
  if (depth_of(text) > kDeepestJson)
    return Error{"expected JSON nested at most " + std::to_string(kDeepestJson) + " deep, got deeper nesting"};
  auto json = nlohmann::json::parse(text, nullptr, /*allow_exceptions=*/false);
  if (json.is_discarded()) return Error{"expected JSON, got something else"};
  return json;
}

std::string shown(const nlohmann::json& value, std::size_t most) {
  const std::string text = value.dump(-1, ' ', true, nlohmann::json::error_handler_t::replace);
  return text.size() <= most ? text : text.substr(0, most) + "…";
}

std::optional<std::int64_t> whole_number(const nlohmann::json& value) {
  constexpr double kGreatestExact = 9007199254740992;  // 2^53
  if (value.is_number_unsigned() && value.get<std::uint64_t>() > static_cast<std::uint64_t>(INT64_MAX))
    return std::nullopt;
  if (value.is_number_integer()) return value.get<std::int64_t>();
  if (!value.is_number_float()) return std::nullopt;
  const double number = value.get<double>();
  // not-a-number fails both comparisons
  if (!(std::abs(number) <= kGreatestExact) || std::trunc(number) != number) return std::nullopt;
  return static_cast<std::int64_t>(number);
}

template <class T>
std::optional<T> number_in_text(const nlohmann::json& object, const char* key) {
  const auto found = object.find(key);
  if (found == object.end() || !found->is_string()) return std::nullopt;
  const auto& text = found->get_ref<const std::string&>();
  T value{};
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc() || end != text.data() + text.size()) return std::nullopt;
  return value;
}

template std::optional<std::int64_t> number_in_text(const nlohmann::json&, const char*);
template std::optional<std::uint64_t> number_in_text(const nlohmann::json&, const char*);

}  // namespace robot
