// Finding a ball that was lost.
#pragma once

#include "sim/agent/view.h"
#include "sim/motion/command.h"

namespace sim::agent {

/// Where a teammate's report is newer than the own sight: turns to the reported place and goes there. Otherwise scans
/// with the head, turns all round to the side where the ball was last, walks to another part of the field, and again.
motion::Command search_ball(const View& view, Mind& mind, float gain);

}  // namespace sim::agent
