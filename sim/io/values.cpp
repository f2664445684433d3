#include "sim/io/values.h"

#include <charconv>
#include <cmath>
#include <vector>

#include "robot/core/json_library.h"
#include "sim/io/source.h"
#include "sim/io/words.h"

namespace sim::io {

using robot::Error;
using robot::Result;

namespace {

constexpr double kDegree = 3.14159265358979323846 / 180;

std::vector<std::string_view> names_in(const char* const* names) {
  std::vector<std::string_view> list;
  for (; *names; ++names) list.emplace_back(*names);
  return list;
}

Error wrong(const Expected& expected, const std::string& got) {
  const std::string unit = *expected.unit ? " [" + std::string(expected.unit) + "]" : "";
  const std::string what = expected.names ? "one of " + listed(names_in(expected.names))
                                          : short_text(expected.least) + " .. " + short_text(expected.most) + unit;
  return {"must be " + what + ", got " + got};
}

Result<float> in_range(double value, const Expected& expected, const std::string& got) {
  const float rounded = std::abs(value) < 1e30 ? static_cast<float>(value) : 1e30f;
  if (!(rounded >= expected.least && rounded <= expected.most)) return wrong(expected, got);
  return rounded;
}

/// Returns the factor from the `given` unit to `unit`, or 0 for another quantity.
double factor_to(std::string_view given, std::string_view unit) {
  if (given.empty() || given == unit) return 1;
  if (given == "deg" && unit == "rad") return kDegree;
  if (given == "cm" && unit == "m") return 0.01;
  if (given == "min" && unit == "s") return 60;
  return 0;
}

/// Returns the value of a kick's name, which it adds to the list if it is new.
Result<float> named_kick(std::string_view name, const Expected& expected) {
  agent::NamedKicks& kicks = *expected.kicks;
  if (name.empty() || name.size() >= sizeof kicks.names[0])
    return Error{"must be " + listed(names_in(expected.names)) + " or a kick's name of 1 .. " +
                 std::to_string(sizeof kicks.names[0] - 1) + " bytes, got " + quoted(name)};
  int place = 0;
  while (place < kicks.count && kicks.names[place] != name) ++place;
  if (place == agent::kMaxNamedKicks)
    return Error{"must be one of the " + std::to_string(agent::kMaxNamedKicks) +
                 " kicks that the tree names before, got one more: " + quoted(name)};
  if (place == kicks.count) name.copy(kicks.names[kicks.count++], name.size());
  return static_cast<float>(names_in(expected.names).size()) + static_cast<float>(place);
}

}  // namespace

Expected expected_of(const agent::ParameterInfo& info, agent::NamedKicks* kicks) {
  const agent::Range& range = info.range;
  return {range.unit, range.least, range.most, range.names, range.names_kicks ? kicks : nullptr};
}

Expected expected_of(const agent::FeatureInfo& info) { return {info.unit, info.least, info.most, info.names}; }

std::string value_text(float value, const Expected& expected) {
  if (expected.names) {
    const auto place = static_cast<std::size_t>(value), words = names_in(expected.names).size();
    return place < words || !expected.kicks ? expected.names[place] : expected.kicks->names[place - words];
  }
  return short_text(value) + (*expected.unit ? " " + std::string(expected.unit) : "");
}

namespace {

const Json kNoParameters = Json::object();

}  // namespace

Values::Values() : Values(kNoParameters) {}

Result<float> Values::read(const Json& value, const Expected& expected) {
  if (value.is_string()) return read(std::string_view(value.get_ref<const std::string&>()), expected);
  if (!value.is_number() || expected.names) return wrong(expected, shown(value));
  return in_range(value.get<double>(), expected, shown(value));
}

Result<float> Values::read(std::string_view text, const Expected& expected) {
  if (text.starts_with('$')) {
    const std::string_view name = text.substr(1);
    const auto found = parameters_.find(std::string(name));
    if (found == parameters_.end()) {
      std::vector<std::string_view> known;
      for (const auto& [key, value] : parameters_.items()) known.emplace_back(key);
      return Error{"names no parameter: " + quoted(name) + hint(name, known)};
    }
    used_.emplace(name);
    // a parameter must not name another: this prevents cycles
    if (found->is_string() && found->get_ref<const std::string&>().starts_with('$'))
      return Error{"is the parameter " + quoted(name) + ", which must be a value, got " + shown(*found)};
    Result<float> value = read(*found, expected);
    if (!value) return Error{"is the parameter " + quoted(name) + ", which " + value.error()};
    return value;
  }
  if (expected.names) {
    for (int i = 0; expected.names[i]; ++i)
      if (text == expected.names[i]) return static_cast<float>(i);
    return expected.kicks ? named_kick(text, expected) : wrong(expected, quoted(text));
  }

  double value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc{}) return wrong(expected, quoted(text));
  std::string_view unit = text.substr(static_cast<std::size_t>(end - text.data()));
  while (unit.starts_with(' ')) unit.remove_prefix(1);
  const double factor = factor_to(unit, expected.unit);
  if (factor == 0)
    return Error{*expected.unit ? "must be in " + std::string(expected.unit) + ", got " + quoted(text)
                                : "must be without a unit, got " + quoted(text)};
  return in_range(factor * value, expected, quoted(text));
}

}  // namespace sim::io
