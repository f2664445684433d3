// foresight-lab play: a recording looks like a live robot.
#pragma once

#include <filesystem>
#include <vector>

#include "robot/app/lab_foresight.h"
#include "robot/app/server_settings.h"
#include "robot/core/result.h"

namespace robot::app {

struct PlayOptions {
  std::vector<std::filesystem::path> sessions;
  double speed = 1;  // 0.01 .. 1000
  bool loop = false;
  double max_clock_offset = 60;  // [s] a session whose clock is further off than that from the first one's is refused
  std::filesystem::path map;     // which of their topics is which of our objects; empty: none is
  LabForesightOptions foresight;
  ServerSettings server;
};

/// Serves the sessions in one time base, that of the first one's clock as far as their clock samples tell, and all others in the folder of the first for download, until the process is
/// told to end. Clients may pause, go elsewhere and change the speed, and ask foresight what would
/// have been best from there on.
Result<void> play(const PlayOptions& options);

}  // namespace robot::app
