// foresight-robot --body nao: the robot is ours; its joints are reached by foresight-guardian.
#pragma once

#include "robot/app/robot_options.h"
#include "robot/core/result.h"

namespace robot::app {

/// Until the process is told to end. Where somebody else has the robot, says who, and goes on as body `attached`.
/// An Error if it cannot begin.
Result<void> run_nao(const RobotOptions& options);

}  // namespace robot::app
