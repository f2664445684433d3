// What the rules ask of every robot, whatever its tree says.
#pragma once

#include "sim/agent/view.h"
#include "sim/motion/command.h"

namespace sim::agent {

/// Changes the command where it would break a rule: at the opponents' kick-off or set play nobody kicks or comes
/// nearer to the ball than Habits.keep_clear, and at their kick-off nobody leaves the own half; nobody but the keeper
/// walks into the own goal area, unless it must get away from the ball.
void mind_manners(const View& view, motion::Command& command);

}  // namespace sim::agent
