// foresight-robot --body attached: the robot is a team's own, whose processes come in by the door.
#pragma once

#include <functional>
#include <memory>
#include <set>
#include <string>

#include "robot/app/robot_options.h"
#include "robot/app/runtime.h"
#include "robot/core/clock.h"
#include "robot/core/result.h"
#include "robot/memory/memory.h"

namespace robot::app {

/// What a body of ours brings to a robot that a team's processes may join; a robot of the team's own has none.
struct OwnBody {
  std::set<std::string> objects;                     // that it writes: processes get them, and do not write them
  std::function<void(net::Services&)> add_services;  // may be empty
  std::function<std::shared_ptr<void>(memory::Memory&, const SessionClock&)> begin;  // lives while the robot runs
};

/// Until the process is told to end. An Error if it cannot begin.
Result<void> run_attached(const RobotOptions& options, const OwnBody& own = {});

}  // namespace robot::app
