// Reports for people: one sentence each, at most one a second from each place in the code.
#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <string_view>

#include "robot/core/clock.h"

namespace robot {

enum class Level { debug = 1, info = 2, warning = 3, error = 4 };

/// One report.
struct Report {
  Level level;
  std::string source;    // the part of the program that reports, such as "logging"
  std::string sentence;  // the fault, its place, the expected and the actual value
};

/// Writes a sentence to stderr and passes it to the listener (which fills the memory object `log`). Any thread.
void report(Level level, std::string_view source, std::string_view sentence);

/// Passes every later report to `listener` too; an empty function removes the listener. When this function returns, the
/// previous listener is not running and will not be called again. The listener must not call `report`.
void set_report_listener(std::function<void(const Report&)> listener);

/// A limit of one report a second, for faults that may happen a thousand times a second. One object per place in the
/// code. Any thread.
class Throttle {
 public:
  /// Works as report() does, but drops sentences that come too soon. The next sentence that passes names their number.
  void report(Level level, std::string_view source, std::string_view sentence, std::uint64_t now_ns = monotonic_ns());

 private:
  std::uint64_t last_ns_ = 0;
  std::uint64_t left_out_ = 0;
};

}  // namespace robot
