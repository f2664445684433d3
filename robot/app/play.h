// foresight-lab play: a recording looks like a live robot.
#pragma once

#include <filesystem>
#include <vector>

#include "robot/app/server_settings.h"
#include "robot/core/result.h"

namespace robot::app {

struct PlayOptions {
  std::vector<std::filesystem::path> sessions;
  double speed = 1;  // 0.01 .. 1000
  bool loop = false;
  ServerSettings server;
};

/// Serves the sessions in one time base, and all others in the folder of the first for download, until the process is
/// told to end. Clients may pause, go elsewhere and change the speed.
Result<void> play(const PlayOptions& options);

}  // namespace robot::app
