#include "robot/logging/sessions/retention.h"

#include <algorithm>
#include <tuple>

namespace robot::logging {
namespace {

/// Reports whether `time_ns` is less than kSafeAgeNs before `start_ns` or after `end_ns`. A time that is farther away on
/// either side makes no session young: one of the two clocks was wrong.
bool is_near(std::uint64_t time_ns, std::uint64_t start_ns, std::uint64_t end_ns) {
  if (time_ns < start_ns) return start_ns - time_ns < kSafeAgeNs;
  return time_ns <= end_ns || time_ns - end_ns < kSafeAgeNs;
}

}  // namespace

bool is_deletable(const Session& session, const Now& now) {
  if (session.info.kept || session.state == SessionState::recording) return false;
  if (!now.boot.empty() && session.info.boot == now.boot) return false;
  return std::ranges::none_of(now.times_ns, [&](std::uint64_t time_ns) {
    return is_near(time_ns, session.start_ns, session.end_ns) ||
           is_near(time_ns, session.changed_ns, session.changed_ns);
  });
}

bool is_older(const Session& left, const Session& right) {
  const auto order = [](const Session& session) {
    return std::tuple(session.info.number, session.start_ns, session.folder.filename());
  };
  return order(left) < order(right);
}

}  // namespace robot::logging
