// A part of what is played, for whoever looks through the whole of it.
#pragma once

#include "robot/body/replay/replay.h"
#include "robot/net/serve/backend.h"

namespace robot::app {

/// Answers `request` out of the recordings of `replay`, in the time and under the topic that they are played in. One
/// answer holds some eight megabytes at most, or one message. Any thread.
net::HttpResponse played_range(const body::Replay& replay, const net::PlayedRequest& request);

}  // namespace robot::app
