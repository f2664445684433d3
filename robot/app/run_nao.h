// foresight-robot --body nao: we drive the robot's hardware. foresight-guardian passes the commands on to the joints.
#pragma once

#include "robot/app/robot_options.h"
#include "robot/core/result.h"

namespace robot::app {

/// Runs until SIGINT or SIGTERM. If another process owns LoLA or a camera, it reports which one and runs as body
/// `attached`. Returns an Error if it cannot begin.
Result<void> run_nao(const RobotOptions& options);

}  // namespace robot::app
