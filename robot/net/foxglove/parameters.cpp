#include "robot/net/foxglove/parameters.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <cstdio>
#include <iterator>
#include <mutex>
#include <utility>

namespace robot::net {
namespace {

constexpr const char* kTypeNames[] = {"true or false", "a whole number", "a number", "a text"};

Error refused(std::string_view name, const std::string& expected) {
  return Error{"parameter '" + std::string(name) + "': expected " + expected};
}

/// Returns a number without trailing zeros: 0.1, not 0.100000.
std::string printed(double number) {
  char text[32];
  std::snprintf(text, sizeof text, "%.9g", number);
  return text;
}

/// Returns the range of `rule` in words: "1 .. 5", "at least 1", "a finite number".
std::string range_of(const ParameterRule& rule) {
  if (rule.min && rule.max) return printed(*rule.min) + " .. " + printed(*rule.max);
  if (rule.min) return "at least " + printed(*rule.min);
  return rule.max ? "at most " + printed(*rule.max) : "a finite number";
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

}  // namespace

Result<void> check_value(std::string_view name, const ParameterValue& value, const ParameterRule& rule) {
  std::optional<double> number;
  if (const auto* whole = std::get_if<std::int64_t>(&value)) number = static_cast<double>(*whole);
  if (const auto* real = std::get_if<double>(&value)) number = *real;
  // not-a-number is refused, too
  const bool inside =
      !number || (std::isfinite(*number) && !(rule.min && *number < *rule.min) && !(rule.max && *number > *rule.max));
  if (!inside) return refused(name, range_of(rule) + ", got " + printed(*number));

  const auto* text = std::get_if<std::string>(&value);
  if (!text || rule.choices.empty() || std::ranges::find(rule.choices, *text) != rule.choices.end()) return {};
  std::string choices;
  for (const std::string& choice : rule.choices) choices += (choices.empty() ? "" : ", ") + choice;
  return refused(name, "one of " + choices + ", got '" + text->substr(0, 100) + "'");
}

void Parameters::declare(std::string name, ParameterValue initial, ParameterRule rule) {
  const std::lock_guard guard(lock_);
  [[maybe_unused]] const bool added =
      entries_.try_emplace(std::move(name), Entry{initial, initial, std::move(rule)}).second;
  assert(added && "a parameter is declared once");
}

std::vector<std::string> Parameters::offer(std::string_view prefix, std::vector<OfferedParameter> offered) {
  std::vector<std::string> problems, changed;
  std::vector<Listener> listeners;
  {
    const std::lock_guard guard(lock_);
    // the former parameters with this prefix stand together
    const auto first = entries_.lower_bound(prefix);
    auto last = first;
    while (last != entries_.end() && last->first.starts_with(prefix)) ++last;
    std::map<std::string, Entry, std::less<>> former(std::make_move_iterator(first), std::make_move_iterator(last));
    entries_.erase(first, last);

    for (OfferedParameter& parameter : offered) {
      assert(parameter.name.starts_with(prefix) && parameter.initial.index() == parameter.present.index());
      Entry entry{std::move(parameter.present), std::move(parameter.initial), std::move(parameter.rule)};
      const auto old = former.find(parameter.name);
      if (old != former.end() && old->second.value != old->second.initial) {
        auto kept = converted(old->second.value, entry.initial);
        if (kept && check_value(parameter.name, *kept, entry.rule))
          entry.value = *std::move(kept);
        else
          problems.push_back("parameter '" + parameter.name +
                             "': the value that was set does not fit the new announcement; the announced value holds");
      }
      if (old == former.end() || old->second.value != entry.value) changed.push_back(parameter.name);
      entries_.insert_or_assign(std::move(parameter.name), std::move(entry));
    }
    listeners = listeners_;
  }
  for (const auto& listener : listeners) listener(changed);
  return problems;
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
  if (auto checked = check_value(name, *wanted, entry.rule); !checked) return checked;
  if (entry.rule.apply)
    if (auto applied = entry.rule.apply(*wanted); !applied) return applied;
  if (!store(std::string(name), *std::move(wanted))) return refused(name, "its former announcement, got a new one");
  return {};
}

void Parameters::update(std::string_view name, ParameterValue value) {
  [[maybe_unused]] const bool stored = store(std::string(name), std::move(value));
  assert(stored && "an update keeps the type");
}

/// Returns false if there is no parameter of this name and type: it was offered anew meanwhile.
bool Parameters::store(const std::string& name, ParameterValue value) {
  std::vector<Listener> listeners;
  {
    const std::lock_guard guard(lock_);
    const auto found = entries_.find(name);
    if (found == entries_.end() || found->second.value.index() != value.index()) return false;
    if (found->second.value == value) return true;
    found->second.value = std::move(value);
    listeners = listeners_;
  }
  for (const auto& listener : listeners) listener({name});
  return true;
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

void Parameters::listen(Listener listener) {
  const std::lock_guard guard(lock_);
  listeners_.push_back(std::move(listener));
}

}  // namespace robot::net
