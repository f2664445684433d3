// Where a robot is, as a person says it: an address, or a name of the team's robots file.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "robot/core/result.h"

namespace robot::lab {

/// A robot and the ways to it, the best first.
struct RobotAddress {
  std::string name;                    // as it was called
  std::vector<std::string> addresses;  // WebSocket addresses: "ws://10.0.14.22:8765/?token=…"
};

/// "10.0.14.22", "tim.local:8765", "[fe80::1]:8765", "ws://…" and "http://…", with a query or without, as a WebSocket
/// address; an Error if it is none. The port is 8765 where none is given.
Result<std::string> web_socket_address(std::string_view text);

/// The robots that `words` mean: each an address, or the name or number of a player of the robots file (as
/// `scripts/deploy` reads it: robot/deploy/robots.example.json). `file` is read only where a word is no address.
/// An Error names the word that means nobody, and who there is.
Result<std::vector<RobotAddress>> find_robots(const std::vector<std::string>& words, const std::filesystem::path& file);

/// $FORESIGHT_ROBOTS, or ~/.config/foresight/robots.json.
std::filesystem::path default_robots_file();

}  // namespace robot::lab
