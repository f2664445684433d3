// Why an agent decided so: the way through its tree with the values compared.
#pragma once

#include <vector>

namespace sim::agent {

/// Filled by Behaviour::decide for whoever asks; the strings belong to the behaviour.
struct Trace {
  struct Node {
    const char* path;  // names from the root, joined by "/"
    const char* name;
    const char* condition;  // as text, e.g. "ball_distance < 0.35"; empty for a leaf
    const char* feature;    // empty for a leaf
    float value = 0;        // [SI] of the feature
    float threshold = 0;
    bool known = true;  // false: the robot did not know the value, which makes the result false
    bool result = true;
  };
  struct Argument {
    const char* name;
    float value;  // [SI]
  };
  const char* strategy = "";  // whose tree it is
  std::vector<Node> visited;  // from the root to the leaf
  const char* skill = "";
  std::vector<Argument> arguments;
  const char* role = "";

  void clear() { strategy = "", visited.clear(), arguments.clear(), skill = "", role = ""; }
};

}  // namespace sim::agent
