// The name of a robot on the command line.
#pragma once

#include <string>
#include <string_view>

#include "robot/core/result.h"

namespace robot::app {

/// The name "<team>/<player>" of a robot: team 0 .. 255 (0 is no team), player 1 .. 99.
struct RobotName {
  int team = 0, player = 1;

  std::string text() const { return std::to_string(team) + "/" + std::to_string(player); }
};

/// Parses a name such as "14/2".
Result<RobotName> parse_robot_name(std::string_view text);

}  // namespace robot::app
