// The rules that every robot keeps, independent of its tree.
#pragma once

#include "sim/agent/view.h"
#include "sim/motion/command.h"

namespace sim::agent {

/// Changes a command that would break a rule. At the opponents' kick-off or set play the robot does not kick. It keeps
/// Habits.keep_clear away from the ball, and at least Rules.clear_distance, without leaving the field. At their kick-off it
/// stays in the own half. Where the rules have an illegal defender, only the keeper walks into the own goal area, except to
/// get away from the ball.
void mind_manners(const View& view, motion::Command& command);

}  // namespace sim::agent
