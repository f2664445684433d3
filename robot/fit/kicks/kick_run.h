// The kicks that a robot made, as its own recording has them.
#pragma once

#include <string>
#include <vector>

#include "robot/fit/evidence.h"

namespace robot::fit {

struct KickRun {
  std::string kind;           // "forward": its name in the models
  bool left = true;           // the foot
  double begin = 0, end = 0;  // [s] by the clock of the truth, since its epoch
  double step = 0;            // [s] between two messages of the motion status; 0: the end is not known
};

/// Reads the runs of a robot: from its motion status, else from its commands.
std::vector<KickRun> read_kick_runs(const WatchedRobot& robot);

}  // namespace robot::fit
