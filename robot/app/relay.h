// foresight-lab relay: live robots, each over one connection, for any number of viewers.
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "robot/app/server_settings.h"
#include "robot/core/result.h"
#include "robot/lab/relay/robot_link.h"

namespace robot::app {

struct RelayOptions {
  std::vector<std::string> robots;    // addresses, or names of the robots file
  std::filesystem::path robots_file;  // empty: the usual one
  lab::Pictures pictures = lab::Pictures::jpeg;
  bool lossless = false;
  double max_clock_offset = 60;  // [s] a robot whose clock is further off is refused
  bool record = false;           // from the first moment on
  std::string name;              // of that session
  std::filesystem::path log_folder = "logs";
  std::uint64_t log_mb = 50'000;
  ServerSettings server;
};

/// Serves what the robots serve, with the same topics and schemas, until the process is told to end. A robot that goes
/// comes back by itself. Their times are those of this machine's clock where their own are off.
Result<void> relay(const RelayOptions& options);

}  // namespace robot::app
