// Retained values: a recording begins with the newest value of each object, which may be much older than the recording.
#pragma once

#include <cstdint>

#include "robot/logging/sessions/session.h"

namespace robot::logging {

/// Moves the start of `session` to the first message that is no retained value, at the latest to `recorded_ns`, when its
/// recorder began [ns since the epoch]. A retained value is the first message of a stream, captured before `recorded_ns`,
/// and each repetition with the same capture time. It keeps its capture time, so its age stays true, but it does not
/// stretch the time line. A session with nothing else has no length and begins at `recorded_ns`. Changes nothing if all
/// messages are older than `recorded_ns` and some stream has several: then the clocks do not agree.
void leave_out_retained(Session& session, std::uint64_t recorded_ns);

}  // namespace robot::logging
