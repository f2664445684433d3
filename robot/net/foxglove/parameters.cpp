#include "robot/net/foxglove/parameters.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <mutex>
#include <utility>

namespace robot::net {
namespace {

constexpr const char* kTypeNames[] = {"true or false", "a whole number", "a number", "a text"};

Error refused(std::string_view name, const std::string& expected) {
  return Error{"parameter '" + std::string(name) + "': expected " + expected};
}

/// Returns a number without trailing zeros: 0.1, not 0.100000.
std::string shown(double number) {
  std::string text = std::to_string(number);
  text.erase(text.find_last_not_of('0') + 1);
  if (text.ends_with('.')) text.pop_back();
  return text;
}

/// Returns `value` converted to the type of `like`, or nothing if that is impossible.
std::optional<ParameterValue> converted(const ParameterValue& value, const ParameterValue& like) {
  if (value.index() == like.index()) return value;
  if (const auto* whole = std::get_if<std::int64_t>(&value); whole && std::holds_alternative<double>(like))
    return static_cast<double>(*whole);
  const auto* number = std::get_if<double>(&value);
  if (number && std::holds_alternative<std::int64_t>(like) && std::nearbyint(*number) == *number &&
      std::abs(*number) < 1e15)
    return static_cast<std::int64_t>(*number);
  return std::nullopt;
}

Result<void> check(std::string_view name, const ParameterValue& value, const ParameterRule& rule) {
  std::optional<double> number;
  if (const auto* whole = std::get_if<std::int64_t>(&value)) number = static_cast<double>(*whole);
  if (const auto* real = std::get_if<double>(&value)) number = *real;
  // not-a-number is refused, too
  const bool inside =
      !number || (std::isfinite(*number) && !(rule.min && *number < *rule.min) && !(rule.max && *number > *rule.max));
  if (!inside && rule.min && rule.max)
    return refused(name, shown(*rule.min) + " .. " + shown(*rule.max) + ", got " + shown(*number));
  if (!inside) return refused(name, "a number in its range, got " + shown(*number));

  const auto* text = std::get_if<std::string>(&value);
  if (!text || rule.choices.empty() || std::ranges::find(rule.choices, *text) != rule.choices.end()) return {};
  std::string choices;
  for (const std::string& choice : rule.choices) choices += (choices.empty() ? "" : ", ") + choice;
  return refused(name, "one of " + choices + ", got '" + text->substr(0, 100) + "'");
}

}  // namespace

void Parameters::declare(std::string name, ParameterValue initial, ParameterRule rule) {
  const std::lock_guard guard(lock_);
  [[maybe_unused]] const bool added =
      entries_.try_emplace(std::move(name), Entry{std::move(initial), std::move(rule)}).second;
  assert(added && "a parameter is declared once");
}

Result<void> Parameters::set(std::string_view name, const ParameterValue& value) {
  Entry entry;
  {
    const std::lock_guard guard(lock_);
    const auto found = entries_.find(name);
    if (found == entries_.end())
      return Error{"parameter '" + std::string(name.substr(0, 100)) + "': there is no parameter of this name"};
    entry = found->second;
  }
  auto wanted = converted(value, entry.value);
  if (!wanted)
    return refused(name, std::string(kTypeNames[entry.value.index()]) + ", got " + kTypeNames[value.index()]);
  if (auto checked = check(name, *wanted, entry.rule); !checked) return checked;
  if (entry.rule.apply)
    if (auto applied = entry.rule.apply(*wanted); !applied) return applied;
  store(std::string(name), *std::move(wanted));
  return {};
}

void Parameters::update(std::string_view name, ParameterValue value) { store(std::string(name), std::move(value)); }

void Parameters::store(const std::string& name, ParameterValue value) {
  std::vector<std::function<void(const std::string&)>> listeners;
  {
    const std::lock_guard guard(lock_);
    const auto found = entries_.find(name);
    assert(found != entries_.end() && found->second.value.index() == value.index());
    if (found == entries_.end() || found->second.value == value) return;
    found->second.value = std::move(value);
    listeners = listeners_;
  }
  for (const auto& listener : listeners) listener(name);
}

std::optional<ParameterValue> Parameters::get(std::string_view name) const {
  const std::lock_guard guard(lock_);
  const auto found = entries_.find(name);
  if (found == entries_.end()) return std::nullopt;
  return found->second.value;
}

bool Parameters::flag(std::string_view name) const { return std::get<bool>(get(name).value()); }
std::int64_t Parameters::integer(std::string_view name) const { return std::get<std::int64_t>(get(name).value()); }
double Parameters::number(std::string_view name) const { return std::get<double>(get(name).value()); }
std::string Parameters::text(std::string_view name) const { return std::get<std::string>(get(name).value()); }

std::vector<std::string> Parameters::names() const {
  const std::lock_guard guard(lock_);
  std::vector<std::string> names;
  for (const auto& [name, entry] : entries_) names.push_back(name);
  return names;
}

void Parameters::listen(std::function<void(const std::string&)> listener) {
  const std::lock_guard guard(lock_);
  listeners_.push_back(std::move(listener));
}

}  // namespace robot::net
