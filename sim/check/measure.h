// Metrics of a game, in the language of conditions:
//
//   metric := condition | "time" "of" fact | "count" "of" happening
//           | "least" quantity | "most" quantity | "final" quantity
//
// A condition is 1 if it holds at the end, otherwise 0: over many games a share. "time of" is the time [s] from the start
// to the first tick in which the fact holds, and absent if there is none.
#pragma once

#include <optional>
#include <string_view>

#include "robot/core/result.h"
#include "sim/check/condition.h"

namespace sim::check {

struct Metric {
  enum class Kind { share, time_of, count_of, least, most, final_value };
  Kind kind = Kind::share;
  Condition condition;  // of a share
  Fact fact;            // of time_of and count_of
  int quantity = -1;    // of the others
};

/// Parses a metric of at most kMaxConditionBytes.
robot::Result<Metric> parse_metric(std::string_view text);

/// Measures one metric in one game.
class Measure {
 public:
  /// `metric` outlives the measure.
  explicit Measure(const Metric& metric) : metric_(metric), watch_(metric.condition) {}

  /// Call with the glance of each tick.
  void see(const Glance& glance);
  /// Returns the value for the game so far, or nothing if it has none.
  std::optional<double> value() const;

 private:
  const Metric& metric_;
  Watch watch_;
  std::optional<double> value_;
  int count_ = 0;
};

}  // namespace sim::check
