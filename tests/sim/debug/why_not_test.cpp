#include "sim/debug/why_not.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <set>
#include <string>
#include <string_view>

#include "tests/sim/debug/played.h"
#include "tests/sim/debug/random_tree.h"

namespace sim::debug {
namespace {

using agent::Feature;
using agent::FeatureInfo;
using test::any_values;
using test::random_tree;

std::size_t index_of(Feature feature) { return static_cast<std::size_t>(feature); }

/// An exhaustive search: all values of a fine grid for all features of a tree.
class Exhaustive {
 public:
  Exhaustive(const agent::Tree& tree, const Values& values, const Goal& goal)
      : tree_(tree), values_(values), goal_(goal), known_(agent::find_feature("ball_known")) {
    std::set<Feature> read{known_};
    for (const agent::Node& node : tree.nodes) {
      read.insert(node.feature);
      if (node.other != agent::kNoFeature) read.insert(node.other);
    }
    // ball_known first, because the features of the ball follow from it
    features_.push_back(known_);
    read.erase(known_);
    features_.insert(features_.end(), read.begin(), read.end());
    Values changed = values;
    visit(0, 0, changed);
  }

  /// Returns the smallest number of changed features, or -1.
  int fewest() const { return fewest_; }

 private:
  /// Returns whether the path reads no feature of a known ball that still has no value.
  bool reads_no_gap(const Values& values) const {
    if (values[index_of(known_)] < 0.5f) return true;
    const auto is_gap = [&](Feature feature) {
      const FeatureInfo& info = info_of(feature);
      return info.needs_ball && !info.at_times_unknown && std::isnan(values[index_of(feature)]);
    };
    for (const std::uint16_t number : evaluate(tree_, values).path) {
      const agent::Node& node = tree_.nodes[number];
      if (is_gap(node.feature) || (node.other != agent::kNoFeature && is_gap(node.other))) return false;
    }
    return true;
  }

  void visit(std::size_t number, int changes, Values& values) {
    if (fewest_ >= 0 && changes >= fewest_) return;
    if (number == features_.size()) {
      if (goal_[leaf_of(tree_, values)] && reads_no_gap(values)) fewest_ = changes;
      return;
    }
    const Feature feature = features_[number];
    const FeatureInfo& info = info_of(feature);
    const float now = values_[index_of(feature)];
    const auto with = [&](float value, int cost) {
      values[index_of(feature)] = value;
      visit(number + 1, changes + cost, values);
      values[index_of(feature)] = now;
    };
    const bool known = values[index_of(known_)] > 0.5f;
    if (info.needs_ball && !known) return with(std::nanf(""), 0);
    with(now, 0);
    if (info.fixed) return;
    if (info.at_times_unknown && !std::isnan(now)) with(std::nanf(""), 1);
    // the thresholds of the random trees are 0 .. 3, the values 0 .. 3.5; times are also compared with each other
    const bool whole = info.kind != FeatureInfo::Kind::number || counts(info);
    const float step = whole ? 1.f : std::string_view(info.unit) == "s" ? 0.125f : 0.5f;
    for (float value = std::max(info.least, -0.5f); value <= std::min(info.most, 4.f); value += step)
      if (value != now) with(value, 1);
  }

  const agent::Tree& tree_;
  const Values& values_;
  const Goal& goal_;
  const Feature known_;
  std::vector<Feature> features_;
  int fewest_ = -1;
};

/// Returns the case as text, for a failure.
std::string described(const agent::Tree& tree, const Values& values, const Goal& goal, const WhyNot& answer) {
  std::string text = "\n";
  for (std::size_t i = tree.nodes.size(); i-- > 0;) {
    const agent::Node& node = tree.nodes[i];
    const std::string other =
        node.other == agent::kNoFeature ? std::to_string(node.threshold) : info_of(node.other).name;
    text += std::to_string(i) + ": " + info_of(node.feature).name + " (" +
            std::to_string(values[index_of(node.feature)]) + ") " + std::to_string(static_cast<int>(node.comparison)) +
            " " + other + " yes " + std::to_string(node.yes) + " no " + std::to_string(node.no) + "\n";
  }
  for (std::size_t i = 0; i < goal.size(); ++i)
    if (goal[i]) text += "goal " + std::to_string(i | agent::kLeafBit) + "\n";
  for (const NewValue& change : answer.values)
    text += std::string(info_of(change.feature).name) + " -> " + std::to_string(change.after) + "\n";
  return text;
}

TEST(WhyNot, OfSmallTreesIsMinimalAndUnreachableOnlyWhereExhaustiveSearchAgrees) {
  std::mt19937 random(1);
  int unreachable = 0, several = 0, reached = 0;
  for (int n = 0; n < 1500; ++n) {
    const agent::Tree tree = random_tree(random, 8);
    const Values values = any_values(random, tree);
    Goal goal(tree.leaves.size());
    goal[random() % goal.size()] = true;
    const WhyNot answer = why_not(tree, values, goal);
    const int expected = Exhaustive(tree, values, goal).fewest();
    ASSERT_NE(answer.kind, WhyNot::Kind::unsure);
    if (answer.kind == WhyNot::Kind::unreachable) {
      ASSERT_EQ(expected, -1) << n;
      ++unreachable;
      continue;
    }
    ASSERT_EQ(static_cast<int>(answer.values.size()), expected) << n << described(tree, values, goal, answer);
    EXPECT_EQ(answer.kind == WhyNot::Kind::reached, expected == 0);
    EXPECT_TRUE(goal[answer.leaf]);
    EXPECT_EQ(leaf_of(tree, with_values(values, answer.values)), answer.leaf);
    reached += answer.values.empty();
    several += answer.values.size() > 1;
  }
  EXPECT_GT(unreachable, 20);
  EXPECT_GT(several, 20);
  EXPECT_GT(reached, 20);
}

TEST(WhyNot, TheReportedChangeReachesTheSkillIn1000RandomMomentsAndSkills) {
  std::mt19937 random(3);
  int changed = 0;
  test::for_each_decision(
      1000, 29,
      [&](const Params& params, const State&, const Decision& decision, const agent::TreeBehaviour& behaviour) {
        const agent::Tree& tree = behaviour.tree();
        const Thought thought(params, tree, decision);
        const Values values = values_of(tree, thought.view());
        Goal goal(tree.leaves.size());
        const agent::Skill skill = tree.leaves[random() % goal.size()].skill;
        for (std::size_t i = 0; i < goal.size(); ++i) goal[i] = tree.leaves[i].skill == skill;
        const WhyNot answer = why_not(tree, values, goal);
        ASSERT_NE(answer.kind, WhyNot::Kind::unsure);
        if (answer.kind == WhyNot::Kind::unreachable) return;
        changed += answer.kind == WhyNot::Kind::changed;
        EXPECT_EQ(tree.leaves[leaf_of(tree, with_values(values, answer.values))].skill, skill);
        // a newly known ball gives its features values, also those that the goal does not need
        const bool newly_known = values[index_of(agent::find_feature("ball_known"))] < 0.5f;
        for (const NewValue& change : answer.values) {
          const FeatureInfo& info = info_of(change.feature);
          EXPECT_FALSE(info.fixed);
          if (!std::isnan(change.after)) {
            EXPECT_TRUE(change.after >= info.least && change.after <= info.most) << info.name;
          }
          // otherwise each change is needed
          if (newly_known) continue;
          std::vector<NewValue> others;
          for (const NewValue& other : answer.values)
            if (other.feature != change.feature) others.push_back(other);
          EXPECT_FALSE(goal[leaf_of(tree, with_values(values, others))]) << info.name;
        }
      });
  EXPECT_GT(changed, 300);
}

TEST(WhyNot, WithoutAKnownBallItsFeaturesAreUnknown) {
  agent::Tree tree;
  tree.leaves.resize(2), tree.leaf_words.resize(2), tree.node_words.resize(1);
  const agent::Feature distance = agent::find_feature("ball_distance"), known = agent::find_feature("ball_known");
  tree.nodes.push_back({distance, agent::Comparison::less, agent::kLeafBit | 1, agent::kLeafBit, 0.5f});
  tree.root = 0;
  Values values(static_cast<std::size_t>(agent::feature_count()), std::nanf(""));
  values[index_of(known)] = 0;
  const WhyNot answer = why_not(tree, values, {false, true});
  ASSERT_EQ(answer.values.size(), 2u);
  for (const NewValue& change : answer.values) {
    if (change.feature == known) {
      EXPECT_EQ(change.after, 1);
    }
    if (change.feature == distance) {
      EXPECT_LT(change.after, 0.5f);
    }
  }
  EXPECT_TRUE(std::isnan(with_values({values}, {{distance, 0, 0.2f}})[index_of(distance)]));
}

}  // namespace
}  // namespace sim::debug
