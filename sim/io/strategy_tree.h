// The compiler from written rules to a tree.
#pragma once

#include <string>

#include "sim/agent/tree.h"
#include "sim/io/json.h"

namespace sim::io {

/// Fills nodes, leaves, words and root of `tree` from "tree", "subtrees" and "parameters" of `strategy`. Returns an
/// error sentence that begins with the place, or an empty text. Each parameter and subtree of `own`, the part in the
/// strategy's own file, must be used.
std::string compile_tree(const Json& strategy, const Json& own, agent::Tree& tree);

/// The same for the rules of "menu", each of which always leads to a leaf. Fills Tree.menu instead of the root.
std::string compile_menu(const Json& strategy, const Json& own, agent::Tree& tree);

}  // namespace sim::io
