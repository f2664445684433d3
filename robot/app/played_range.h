// Parts of the played recording as files, for clients that search the whole recording.
#pragma once

#include "robot/body/replay/replay.h"
#include "robot/net/serve/backend.h"

namespace robot::app {

/// Answers `request` with an MCAP file of one topic, with the times and the topic name of the playback. An answer holds
/// about 8 MB, or one message if that is larger. The header net::kPlayedUntil says up to which time it reaches.
/// Called by any thread.
net::HttpResponse played_range(const body::Replay& replay, const net::PlayedRequest& request);

}  // namespace robot::app
