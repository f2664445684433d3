// foresight-lab relay: a server that shows live robots, each read over one connection, to any number of viewers.
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "robot/app/recording_settings.h"
#include "robot/app/server_settings.h"
#include "robot/core/result.h"
#include "robot/lab/relay/robot_link.h"

namespace robot::app {

/// The options of foresight-lab relay.
struct RelayOptions {
  std::vector<std::string> robots;    // addresses, or names of the robots file
  std::filesystem::path robots_file;  // empty: lab::default_robots_file()
  lab::Pictures pictures = lab::Pictures::jpeg;
  bool lossless = false;
  double max_clock_offset = 60;  // [s] greatest accepted offset of a robot's clock from ours
  RecordingSettings recording;
  ServerSettings server;
};

/// Serves the channels of the robots, with the same topics and schemas, until SIGINT or SIGTERM. After a lost
/// connection it connects again by itself. Its page and its recordings have the rules of the first robot that reports
/// some. The times of a robot with a wrong clock are shifted to this machine's clock.
Result<void> relay(const RelayOptions& options);

}  // namespace robot::app
