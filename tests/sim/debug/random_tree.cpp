#include "tests/sim/debug/random_tree.h"

#include <cmath>
#include <iterator>

namespace sim::debug::test {

using agent::Comparison;
using agent::FeatureInfo;

agent::Tree random_tree(std::mt19937& random, unsigned most) {
  constexpr Comparison kOfNumbers[] = {Comparison::less, Comparison::greater, Comparison::at_most,
                                       Comparison::at_least};
  // few features a tree, with few thresholds
  const auto up_to = [&](unsigned end) { return static_cast<unsigned>(random() % end); };
  const unsigned first = up_to(std::size(kFeatures)), few = 2 + up_to(3);
  agent::Tree tree;
  tree.leaves.resize(2 + random() % 4);
  tree.leaf_words.resize(tree.leaves.size());
  const unsigned count = 1 + up_to(most);
  for (unsigned i = 0; i < count; ++i) {
    const char* name = kFeatures[(first + random() % few) % std::size(kFeatures)];
    agent::Node node{agent::find_feature(name), {}, 0, 0, 0};
    const FeatureInfo& info = info_of(node.feature);
    switch (info.kind) {
      case FeatureInfo::Kind::yes_no:
        node.comparison = random() % 2 ? Comparison::greater : Comparison::at_most;
        node.threshold = 0.5f;
        break;
      case FeatureInfo::Kind::name:
        node.comparison = random() % 2 ? Comparison::equal : Comparison::unequal;
        node.threshold = static_cast<float>(random() % static_cast<unsigned>(info.most + 1));
        break;
      case FeatureInfo::Kind::number:
        node.comparison = kOfNumbers[random() % 4];
        node.threshold = static_cast<float>(random() % 4);
        if (std::string_view(name) == "time_to_ball" && random() % 2)
          node.other = agent::find_feature("mates_time_to_ball");
        if (std::string_view(name) == "mates_time_to_ball" && random() % 2)
          node.other = agent::find_feature("time_to_ball");
        break;
    }
    // the last nodes are near the root, and lead to earlier ones
    const auto target = [&]() -> std::uint16_t {
      if (i > 0 && up_to(3) > 0) return static_cast<std::uint16_t>(i - 1 - up_to(std::min(i, 3u)));
      return static_cast<std::uint16_t>(up_to(static_cast<unsigned>(tree.leaves.size())) | agent::kLeafBit);
    };
    node.yes = target(), node.no = target();
    tree.nodes.push_back(node);
    tree.node_words.emplace_back();
  }
  tree.root = static_cast<std::uint16_t>(count - 1);
  return tree;
}

Values any_values(std::mt19937& random, const agent::Tree&) {
  Values values(static_cast<std::size_t>(agent::feature_count()), std::nanf(""));
  const bool known = random() % 4 != 0;
  for (const char* name : kFeatures) {
    const agent::Feature feature = agent::find_feature(name);
    const FeatureInfo& info = info_of(feature);
    float& value = values[static_cast<std::size_t>(feature)];
    if (info.needs_ball && !known) continue;
    if (info.at_times_unknown && random() % 4 == 0) continue;
    if (info.kind == FeatureInfo::Kind::number)
      value = static_cast<float>(random() % 8) * (counts(info) ? 1.f : 0.5f);
    else
      value = static_cast<float>(random() % static_cast<unsigned>(info.most + 1));
    if (counts(info)) value = std::min(value, info.most);
  }
  values[static_cast<std::size_t>(agent::find_feature("ball_known"))] = known ? 1 : 0;
  return values;
}

}  // namespace sim::debug::test
