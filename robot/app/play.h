// foresight-lab play: a recording looks like a live robot.
#pragma once

#include <filesystem>

#include "robot/app/server_settings.h"
#include "robot/core/result.h"

namespace robot::app {

struct PlayOptions {
  std::filesystem::path session;
  double speed = 1;  // 0.01 .. 1000
  bool loop = false;
  ServerSettings server;
};

/// Serves the session, and all others in its folder for download, until the process is told to end.
Result<void> play(const PlayOptions& options);

}  // namespace robot::app
