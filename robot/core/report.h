// Telling people what happened: one sentence, at most once a second per place.
#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <string_view>

#include "robot/core/clock.h"

namespace robot {

enum class Level { debug = 1, info = 2, warning = 3, error = 4 };

/// One thing that was said.
struct Report {
  Level level;
  std::string source;    // the part that speaks, such as "logging"
  std::string sentence;  // what happened, where, what was expected, what came
};

/// Says a sentence: to stderr, and to whoever listens (the memory object `log`). Any thread.
void report(Level level, std::string_view source, std::string_view sentence);

/// Sends every further report to `listener` as well; an empty function ends that.
/// When this returns, the previous listener is no longer being called. The listener must not call `report`.
void set_report_listener(std::function<void(const Report&)> listener);

/// Lets one report a second through, for things that may go wrong a thousand times a second. Any thread; keep one per place.
class Throttle {
 public:
  /// As report(); the next sentence that passes tells how many were left out meanwhile.
  void report(Level level, std::string_view source, std::string_view sentence, std::uint64_t now_ns = monotonic_ns());

 private:
  std::uint64_t last_ns_ = 0;
  std::uint64_t left_out_ = 0;
};

}  // namespace robot
