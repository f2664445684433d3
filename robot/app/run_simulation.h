// foresight-robot --body sim: the robot plays in a simulated game.
#pragma once

#include "robot/app/robot_options.h"
#include "robot/core/result.h"

namespace robot::app {

/// Runs until SIGINT or SIGTERM. Returns an Error if it cannot begin.
Result<void> run_simulation(const RobotOptions& options);

}  // namespace robot::app
