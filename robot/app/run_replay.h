// foresight-robot --body replay: sensor data and all other objects come from a recording.
#pragma once

#include "robot/app/robot_options.h"
#include "robot/core/result.h"

namespace robot::app {

/// Runs until SIGINT or SIGTERM. Returns an Error if it cannot begin.
Result<void> run_replay(const RobotOptions& options);

}  // namespace robot::app
