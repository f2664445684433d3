#include "robot/logging/sessions/retained.h"

#include <algorithm>
#include <memory>

#include "robot/core/clock.h"
#include "robot/logging/sessions/session_provider.h"

namespace robot::logging {
namespace {

/// A first message so little before the recording is no retained value, but one that was on its way [ns].
constexpr std::uint64_t kNearNs = 200 * kMillisecond;

/// Returns the capture time of the first message that is no retained value, or `recorded_ns` if it cannot be read.
std::uint64_t first_moving_ns(const Session& session, const StreamFile& stream, std::uint64_t recorded_ns) {
  if (stream.start_ns + kNearNs >= recorded_ns) return stream.start_ns;
  const std::unique_ptr<InProvider> provider = provider_of(session, stream);
  if (!provider->open()) return recorded_ns;
  const auto first = provider->read();
  if (!first || !*first) return recorded_ns;
  if ((*first)->capture_ns + kNearNs >= recorded_ns) return (*first)->capture_ns;
  while (true) {
    const auto next = provider->read();
    if (!next || !*next) return recorded_ns;
    // a writer that repeats its value with the old capture time, or a robot that connects again, moves nothing
    if ((*next)->capture_ns != (*first)->capture_ns) return (*next)->capture_ns;
  }
}

/// Reports whether the session holds nothing but retained values: one message of each object, all of them older.
bool has_only_retained(const Session& session, std::uint64_t recorded_ns) {
  return session.end_ns + kNearNs < recorded_ns &&
         std::ranges::all_of(session.streams, [](const StreamFile& stream) { return stream.messages <= 1; });
}

}  // namespace

void leave_out_retained(Session& session, std::uint64_t recorded_ns) {
  if (session.end_ns > 0 && has_only_retained(session, recorded_ns)) session.start_ns = session.end_ns = recorded_ns;
  if (recorded_ns >= session.end_ns || recorded_ns <= session.start_ns + kNearNs) return;
  std::uint64_t first_ns = recorded_ns;
  for (const StreamFile& stream : session.streams) {
    if (stream.messages < 2 || stream.start_ns >= recorded_ns) continue;
    first_ns = std::min(first_ns, first_moving_ns(session, stream, recorded_ns));
  }
  session.start_ns = std::max(session.start_ns, first_ns);
}

}  // namespace robot::logging
