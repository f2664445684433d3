// Left and right exchanged.
//
// The law: a mirrored behaviour in a mirrored situation decides the mirrored command, to the bit.
#pragma once

#include "sim/agent/beliefs.h"
#include "sim/agent/mind.h"
#include "sim/agent/tree.h"
#include "sim/motion/command.h"

namespace sim::agent {

Beliefs mirrored(Beliefs beliefs);
Mind mirrored(Mind mind);
motion::Command mirrored(motion::Command command);
/// Returns the tree for the mirrored field: it compares lateral features the other way round, also with each other. Its
/// lateral arguments and the y of its kick-off places are negated.
Tree mirrored(Tree tree);

}  // namespace sim::agent
