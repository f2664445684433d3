// foresight-lab play: a server that shows recordings like a live robot.
#pragma once

#include <filesystem>
#include <vector>

#include "robot/app/lab_foresight.h"
#include "robot/app/server_settings.h"
#include "robot/core/result.h"

namespace robot::app {

/// The options of foresight-lab play.
struct PlayOptions {
  std::vector<std::filesystem::path> sessions;
  double speed = 1;  // 0.01 .. 1000
  bool loop = false;
  double max_clock_offset = 60;  // [s] greatest accepted offset from the clock of the first session
  std::filesystem::path map;     // mapping file (robot/lab/mapping/mapping.h); empty: no topic is mapped
  LabForesightOptions foresight;
  ServerSettings server;
};

/// Serves the sessions until SIGINT or SIGTERM. Their common time base is the clock of the first session, as far as the
/// recorded clock samples allow. The log says which messages of a file are left out, and why. All sessions in the
/// folder of the first one can be downloaded. Clients may pause, seek, change the speed, and ask foresight for the best
/// strategy at the current moment. The service watch_session plays another session of that folder at the same address.
Result<void> play(PlayOptions options);

}  // namespace robot::app
