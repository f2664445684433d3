// foresight-robot --body attached: the robot is a team's own, whose processes come in by the door.
#pragma once

#include "robot/app/robot_options.h"
#include "robot/core/result.h"

namespace robot::app {

/// Until the process is told to end. An Error if it cannot begin.
Result<void> run_attached(const RobotOptions& options);

}  // namespace robot::app
