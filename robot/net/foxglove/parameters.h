// Named values that people may change while the robot runs.
#pragma once

#include <cstdint>
#include <functional>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "robot/core/lock.h"
#include "robot/core/result.h"

namespace robot::net {

using ParameterValue = std::variant<bool, std::int64_t, double, std::string>;

/// The rule for a parameter's values. The type is that of its first value.
struct ParameterRule {
  std::optional<double> min, max;    // of numbers, both included
  std::vector<std::string> choices;  // of texts; empty: any

  /// Applies the new value before it is stored; an Error refuses the value. Called by the thread that sets, without
  /// locks. The server sets on a thread that may wait. Empty: the value has no further effect.
  std::function<Result<void>(const ParameterValue&)> apply = {};
};

/// A parameter that another part offers while the table is in use.
struct OfferedParameter {
  std::string name;
  ParameterValue initial;  // the default
  ParameterValue present;  // of the same type; fits the rule
  ParameterRule rule;
};

/// Checks the range or the choices of a value; the type is right already. Returns an Error that names the parameter.
Result<void> check_value(std::string_view name, const ParameterValue& value, const ParameterRule& rule);

/// The table of parameters. Any thread.
class Parameters {
 public:
  /// Adds a parameter. Call it once for each name, before other threads use the table.
  void declare(std::string name, ParameterValue initial, ParameterRule rule = {});

  /// Replaces all parameters whose names begin with `prefix` by `offered`, whose names begin with it too. A value that was
  /// set stays: one that differs from the initial value of its parameter so far. Returns a sentence for each value that
  /// was set and does not fit its parameter any more.
  std::vector<std::string> offer(std::string_view prefix, std::vector<OfferedParameter> offered);

  /// Sets a value for a client or a person: checks its type and range, applies the rule, and notifies the listeners.
  /// Converts a whole number if the parameter is a number, and 3.0 if it is a whole number.
  Result<void> set(std::string_view name, const ParameterValue& value);

  /// Stores a value that changed by other means, such as a recording that ended, and notifies the listeners. No checks.
  void update(std::string_view name, ParameterValue value);

  /// Returns the value of `name`, or nothing if there is no such parameter.
  std::optional<ParameterValue> get(std::string_view name) const;

  /// Returns the value of a parameter that is declared with this type (asserted).
  bool flag(std::string_view name) const;
  std::int64_t integer(std::string_view name) const;
  double number(std::string_view name) const;
  std::string text(std::string_view name) const;

  /// Returns all names, in alphabetical order.
  std::vector<std::string> names() const;

  using Listener = std::function<void(const std::vector<std::string>& names)>;

  /// Calls `listener` from now on with the names of the parameters that changed, on the thread that changes them. No names:
  /// parameters have gone. The listener reads the values itself. It stays as long as the table.
  void listen(Listener listener);

 private:
  struct Entry {
    ParameterValue value, initial;
    ParameterRule rule;
  };

  bool store(const std::string& name, ParameterValue value);

  mutable Mutex lock_;
  std::map<std::string, Entry, std::less<>> entries_;
  std::vector<Listener> listeners_;
};

}  // namespace robot::net
