#include "robot/app/robot_name.h"

#include <charconv>

namespace robot::app {

Result<RobotName> parse_robot_name(std::string_view text) {
  RobotName name;
  const char* const end = text.data() + text.size();
  const auto [slash, bad_team] = std::from_chars(text.data(), end, name.team);
  if (bad_team == std::errc() && slash != end && *slash == '/') {
    const auto [rest, bad_player] = std::from_chars(slash + 1, end, name.player);
    if (bad_player == std::errc() && rest == end && name.team >= 0 && name.team <= 255 && name.player >= 1 &&
        name.player <= 99)
      return name;
  }
  return Error{"robot: expected <team 0..255>/<player 1..99> such as 14/2, got '" + std::string(text) + "'"};
}

}  // namespace robot::app
