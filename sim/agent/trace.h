// The reasons of a decision: the path through the tree with the compared values.
#pragma once

#include <vector>

namespace sim::agent {

/// The trace of one decision, filled by Behaviour::decide. The behaviour owns the strings.
struct Trace {
  struct Node {
    const char* path;  // names from the root, joined by "/"
    const char* name;
    const char* condition;  // as text, e.g. "ball_distance < 0.35"; empty for a leaf
    const char* feature;    // empty for a leaf
    float value = 0;        // [SI] of the feature
    float threshold = 0;    // [SI], or the value of the other feature; NaN: unknown, and the result is false
    bool known = true;      // false: the robot does not know the value, and the result is false
    bool result = true;
  };
  struct Argument {
    const char* name;
    float value;  // [SI]
  };
  const char* strategy = "";  // name of the tree
  std::vector<Node> visited;  // from the root to the leaf
  const char* skill = "";
  std::vector<Argument> arguments;
  const char* role = "";

  void clear() { strategy = "", visited.clear(), arguments.clear(), skill = "", role = ""; }
};

}  // namespace sim::agent
