// foresight-robot --body attached: the robot runs a team's own processes, which connect through the door.
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

/// The parts of our own body (nao), for a robot that a team's processes may join as well. All empty for body attached.
struct OwnBody {
  std::set<std::string> objects;                     // that the body writes; processes may only read them
  std::function<void(net::Services&)> add_services;  // may be empty
  std::function<Result<std::shared_ptr<void>>(memory::Memory&, const SessionClock&, Runtime&)>
      begin;  // value lives until the end
};

/// Runs until SIGINT or SIGTERM. Returns an Error if it cannot begin.
Result<void> run_attached(const RobotOptions& options, const OwnBody& own = {});

}  // namespace robot::app
