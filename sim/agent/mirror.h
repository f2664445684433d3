// Left and right exchanged.
//
// The law: what a mirrored behaviour decides in a mirrored situation is the mirrored command, to the bit.
#pragma once

#include "sim/agent/beliefs.h"
#include "sim/agent/mind.h"
#include "sim/agent/tree.h"
#include "sim/motion/command.h"

namespace sim::agent {

Beliefs mirrored(Beliefs beliefs);
Mind mirrored(Mind mind);
motion::Command mirrored(motion::Command command);
/// Lateral features are compared the other way round, lateral arguments and the places of the kick-off change sign.
Tree mirrored(Tree tree);

}  // namespace sim::agent
