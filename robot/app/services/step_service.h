// The service by which clients step through a played recording, message by message.
#pragma once

#include <cstdint>

#include "robot/logging/streams/provider.h"
#include "robot/net/foxglove/services.h"

namespace robot::app {

/// The most messages of one step.
inline constexpr std::int64_t kLongestStep = 100;

/// Adds `message_beside`: {"topic": "/truth/world", "from_ns": "1700000000000000000", "by": -3} -> {"ok": true, "at_ns"}.
/// `at_ns` is the capture time of the message that is `by` messages after `from_ns`, or before it if negative. Near an
/// end of the recording it is that of the last message in this direction, or `from_ns` if there is none. Messages of one
/// time count as one. `by` is a whole number from -kLongestStep to kLongestStep. The page cannot find these times in its
/// own history, because a slow page does not receive every message. `open` opens streams with
/// the times of the playback; the thread that serves control calls it.
void add_step_service(net::Services& services, logging::StreamOf open);

}  // namespace robot::app
