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

  /// Does what the new value asks for, before it is stored; an Error refuses the value. Called by the thread that sets,
  /// without locks; the server sets on a thread that may wait. Empty: nothing is to be done.
  std::function<Result<void>(const ParameterValue&)> apply = {};
};

/// The table of parameters. Any thread.
class Parameters {
 public:
  /// Adds a parameter. Each name once, before anybody else uses the table.
  void declare(std::string name, ParameterValue initial, ParameterRule rule = {});

  /// Sets what a client or a person asks for: type and range are checked, the rule is applied, the listeners are told.
  /// A whole number passes where a number is expected, and 3.0 where a whole number is.
  Result<void> set(std::string_view name, const ParameterValue& value);

  /// Stores a value that changed by other means, such as a recording that ended, and notifies the listeners. No checks.
  void update(std::string_view name, ParameterValue value);

  /// The value of `name`; nothing if there is no such parameter.
  std::optional<ParameterValue> get(std::string_view name) const;

  /// The value of a parameter that is declared with this type (asserted).
  bool flag(std::string_view name) const;
  std::int64_t integer(std::string_view name) const;
  double number(std::string_view name) const;
  std::string text(std::string_view name) const;

  /// All names, in alphabetical order.
  std::vector<std::string> names() const;

  /// From now on `listener` is called with the name of each parameter that changes, by the thread that changes it.
  /// It reads the value itself; listeners stay as long as the table.
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
