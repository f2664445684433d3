// The mean motion of a robot that follows commands: the simulator's walk without its luck.
#pragma once

#include <vector>

#include "sim/motion/command.h"
#include "sim/motion/model.h"

namespace robot::fit {

/// A velocity [m/s, robot] and a turn rate [rad/s].
struct WalkRates {
  double x = 0, y = 0, turn = 0;
};

/// The gait of one command: its mean over the luck of steps, and the variance of a step.
struct MeanGait {
  WalkRates mean, variance;
};

/// Reports whether a command asks the legs to move.
bool asks_to_walk(const sim::motion::Command& command);

/// Returns the gait of a command that asks to walk. Where a limit clips the luck of the steps, the mean is below the limit.
MeanGait mean_gait(const sim::motion::Walk& walk, const sim::motion::Command& command);

/// Returns the mean rates during each tick of 1/30 s, with one command for each tick. The body follows the rules of sim/motion with
/// limits of acceleration, but a delay need not be a whole number of ticks. The phase of the steps is not known: the rates are the
/// mean over four phases. The body walks already if the first command asks for it, else it stands.
std::vector<WalkRates> mean_walk(const sim::motion::Walk& walk, const std::vector<sim::motion::Command>& commands);

}  // namespace robot::fit
