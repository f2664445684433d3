#include "robot/lab/clocks/clock_offset.h"

#include <cstdio>
#include <cstdlib>

namespace robot::lab {

ClockOffset offset_by(std::uint64_t sent_ns, std::uint64_t theirs_ns, std::uint64_t returned_ns) {
  // estimate: the peer read its clock half-way between; the error is half the round trip at most
  const std::uint64_t round_trip_ns = returned_ns - sent_ns;
  return {.offset_ns = static_cast<std::int64_t>(theirs_ns - (sent_ns + round_trip_ns / 2)),
          .error_ns = (round_trip_ns + 1) / 2};
}

ClockOffset better(const std::optional<ClockOffset>& known, const ClockOffset& other) {
  return known && known->error_ns <= other.error_ns ? *known : other;
}

std::string to_text(const ClockOffset& offset) {
  char text[80];
  std::snprintf(text, sizeof text, "%.3f s %s (± %.1f ms)", std::abs(static_cast<double>(offset.offset_ns)) * 1e-9,
                offset.offset_ns < 0 ? "behind" : "ahead", static_cast<double>(offset.error_ns) * 1e-6);
  return text;
}

Result<std::int64_t> correction(const ClockOffset& offset, std::uint64_t most_ns, const std::string& who) {
  const auto size_ns = static_cast<std::uint64_t>(std::abs(offset.offset_ns));
  if (size_ns <= offset.error_ns + kAgreeNs) return std::int64_t{0};
  if (size_ns <= most_ns) return -offset.offset_ns;
  char most[32];
  std::snprintf(most, sizeof most, "%g", static_cast<double>(most_ns) * 1e-9);
  return Error{who + " clock is " + to_text(offset) + ", more than the " + most +
               " s of --max-clock-offset: set the clock right, or allow more"};
}

}  // namespace robot::lab
