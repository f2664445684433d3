#include "sim/debug/evaluation.h"

namespace sim::debug {
Values values_of(const agent::Tree& tree, const agent::View& view) {
  Values values(static_cast<std::size_t>(agent::feature_count()), agent::kUnknown);
  const auto set = [&](agent::Feature feature) { values[index_of(feature)] = agent::value_of(feature, view); };
  set(agent::find_feature("ball_known"));
  for (const agent::Node& node : tree.nodes) {
    set(node.feature);
    if (node.other != agent::kNoFeature) set(node.other);
  }
  return values;
}

Answer answer_of(const agent::Node& node, const Values& values) {
  const float value = values[index_of(node.feature)];
  const float threshold = node.other == agent::kNoFeature ? node.threshold : values[index_of(node.other)];
  return {value, threshold, agent::holds(node.comparison, value, threshold)};
}

std::uint16_t next_of(const agent::Node& node, const Values& values) {
  return answer_of(node, values).result ? node.yes : node.no;
}

std::uint16_t leaf_from(const agent::Tree& tree, std::uint16_t at, const Values& values) {
  while (!(at & agent::kLeafBit)) at = next_of(tree.nodes[at], values);
  return static_cast<std::uint16_t>(at & ~agent::kLeafBit);
}

Evaluation evaluate(const agent::Tree& tree, const Values& values) {
  Evaluation all;
  for (const agent::Node& node : tree.nodes) all.nodes.push_back(answer_of(node, values));
  std::uint16_t at = tree.root;
  while (!(at & agent::kLeafBit)) {
    all.path.push_back(at);
    at = all.nodes[at].result ? tree.nodes[at].yes : tree.nodes[at].no;
  }
  all.leaf = static_cast<std::uint16_t>(at & ~agent::kLeafBit);
  return all;
}

}  // namespace sim::debug
