#include "sim/debug/tree_change.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <tuple>

namespace sim::debug {
namespace {

constexpr int kNoWay = std::numeric_limits<int>::max();

/// The cheapest way from a node to the goal.
struct Way {
  int changes = kNoWay;
  float size = 0;        // sum of changes, by scale_of
  bool flipped = false;  // the node itself answers otherwise

  bool is_before(const Way& other) const { return std::tie(changes, size) < std::tie(other.changes, other.size); }
};

}  // namespace

std::optional<std::vector<NewThreshold>> nearest_thresholds(const agent::Tree& tree, const Values& values,
                                                            const Goal& goal) {
  // a node leads to leaves and nodes with lower numbers, so these are done first
  std::vector<Way> ways(tree.nodes.size());
  const auto way_of = [&](std::uint16_t at) {
    if (!(at & agent::kLeafBit)) return ways[at];
    return goal[at & ~agent::kLeafBit] ? Way{.changes = 0} : Way{};
  };
  for (std::size_t i = 0; i < tree.nodes.size(); ++i) {
    const agent::Node& node = tree.nodes[i];
    const Answer answer = answer_of(node, values);
    Way best = way_of(answer.result ? node.yes : node.no);
    best.flipped = false;
    Way other = way_of(answer.result ? node.no : node.yes);
    const Flip flip = flip_of(node, answer);
    if (!std::isnan(flip.threshold) && other.changes != kNoWay) {
      other.changes += 1;
      other.size += std::abs(flip.threshold - node.threshold) / scale_of(info_of(node.feature));
      other.flipped = true;
      if (other.is_before(best)) best = other;
    }
    ways[i] = best;
  }

  if (way_of(tree.root).changes == kNoWay) return {};
  std::vector<NewThreshold> changes;
  for (std::uint16_t at = tree.root; !(at & agent::kLeafBit);) {
    const agent::Node& node = tree.nodes[at];
    const Answer answer = answer_of(node, values);
    if (ways[at].flipped) changes.push_back({at, node.threshold, flip_of(node, answer).threshold});
    at = answer.result != ways[at].flipped ? node.yes : node.no;
  }
  return changes;
}

agent::Tree with_thresholds(agent::Tree tree, const std::vector<NewThreshold>& changes) {
  for (const NewThreshold& change : changes) tree = with_threshold(std::move(tree), change.node, change.after);
  return tree;
}

}  // namespace sim::debug
