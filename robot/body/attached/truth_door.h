// The door of a ground-truth server: a lab's own process reports the truth, without being a robot.
#pragma once

#include <filesystem>
#include <memory>
#include <set>
#include <string>

#include "robot/body/attached/door.h"
#include "robot/core/clock.h"
#include "robot/core/result.h"
#include "robot/logging/streams/board.h"
#include "robot/memory/channels.h"

namespace robot::body {

/// Opens a door whose processes write /truth/world (foresight.GroundTruth) and any other topic below /truth/, such as the
/// images of their camera. The name "world" means /truth/world. Other topics are refused for writing; all can be read.
///
/// Lists /truth/world in `channels` if it is not there, so that a wrong type is refused. `own_objects` are those below
/// /truth/ that only the server writes: {"world"} if it has sensors of its own. `path`: usually default_door().
/// Returns an Error if another program listens there. `clock`, `channels` and `board` outlive the door.
Result<std::unique_ptr<Door>> open_truth_door(std::filesystem::path path, const std::set<std::string>& own_objects,
                                              const SessionClock& clock, memory::Channels& channels,
                                              logging::LoggingBoard& board);

}  // namespace robot::body
