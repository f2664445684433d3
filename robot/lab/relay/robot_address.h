// Addresses of robots from the command line: an address, or a name of the team's robots file.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "robot/core/result.h"

namespace robot::lab {

/// A robot and its addresses, the best first.
struct RobotAddress {
  std::string name;                    // as on the command line, without a token
  std::vector<std::string> addresses;  // WebSocket addresses: "ws://10.0.14.22:8765/?token=…"
};

/// Converts "10.0.14.22", "tim.local:8765", "[fe80::1]:8765", "ws://…" and "http://…", with a query or without, to a
/// WebSocket address. The default port is 8765. Returns an Error for other texts.
Result<std::string> web_socket_address(std::string_view text);

/// Returns the robots that `words` name. Each word is an address, or the name or player number of a robot in the robots
/// file of `scripts/deploy` (robot/deploy/robots.example.json). `file` is read only if a word is not an address. An
/// Error names the unknown word and the robots of the file.
Result<std::vector<RobotAddress>> find_robots(const std::vector<std::string>& words, const std::filesystem::path& file);

/// Returns $FORESIGHT_ROBOTS, or ~/.config/foresight/robots.json.
std::filesystem::path default_robots_file();

}  // namespace robot::lab
