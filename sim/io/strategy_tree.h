// From rules as written to a compiled tree.
#pragma once

#include <string>

#include "sim/agent/tree.h"
#include "sim/io/json.h"

namespace sim::io {

/// Fills nodes, leaves, words and root of `tree` from "tree", "subtrees" and "parameters" of `strategy`. Returns what
/// is wrong: a sentence that begins with the place, empty if nothing is. Of `own`, the part that the strategy does not
/// have from others, each parameter and subtree must be used.
std::string compile_tree(const Json& strategy, const Json& own, agent::Tree& tree);

}  // namespace sim::io
