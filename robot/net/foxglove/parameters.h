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

/// The table of parameters. Any thread.
class Parameters {
 public:
  /// Adds a parameter. Call it once for each name, before other threads use the table.
  void declare(std::string name, ParameterValue initial, ParameterRule rule = {});

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

  /// Calls `listener` from now on with the name of each parameter that changes, on the thread that changes it.
  /// The listener reads the value itself. It stays as long as the table.
  void listen(std::function<void(const std::string& name)> listener);

 private:
  struct Entry {
    ParameterValue value;
    ParameterRule rule;
  };

  void store(const std::string& name, ParameterValue value);

  mutable Mutex lock_;
  std::map<std::string, Entry, std::less<>> entries_;
  std::vector<std::function<void(const std::string&)>> listeners_;
};

}  // namespace robot::net
