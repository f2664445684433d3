#include "sim/debug/flip.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

namespace sim::debug {
namespace {

using agent::Comparison;

constexpr Comparison kOfNumbers[] = {Comparison::less, Comparison::greater, Comparison::at_most, Comparison::at_least};

agent::Feature named(const char* name) { return agent::find_feature(name); }

Answer answer(const agent::Node& node, float value) {
  return {value, node.threshold, holds(node.comparison, value, node.threshold)};
}

TEST(Flip, BothWaysGiveTheOtherAnswerAndHalfTheWayDoesNot) {
  std::mt19937 random(1);
  const auto any = [&] { return static_cast<float>(random() % 3000) / 100.f; };
  for (int n = 0; n < 4000; ++n) {
    const agent::Node node{named("ball_distance"), kOfNumbers[n % 4], 0, 0, any()};
    const float value = n % 7 == 0 ? node.threshold : any();
    const Answer now = answer(node, value);
    const Flip flip = flip_of(node, now);
    if (!std::isnan(flip.value)) {
      EXPECT_NE(holds(node.comparison, flip.value, node.threshold), now.result);
      const float half = value + 0.5f * (flip.value - value);
      if (half != flip.value) {
        EXPECT_EQ(holds(node.comparison, half, node.threshold), now.result);
      }
    }
    // at the ends of the range a threshold may have to be outside
    if (std::isnan(flip.threshold)) {
      EXPECT_TRUE(value == 0 || value == 30) << value;
      continue;
    }
    EXPECT_NE(holds(node.comparison, value, flip.threshold), now.result);
  }
}

TEST(Flip, AnImpossibleValueIsNoWay) {
  // no distance is below 0, and no opponent is a half one
  const agent::Node distance{named("ball_distance"), Comparison::at_least, 0, 0, 0};
  EXPECT_TRUE(std::isnan(flip_of(distance, answer(distance, 1)).value));
  const agent::Node known{named("opponents_known"), Comparison::less, 0, 0, 1};
  EXPECT_EQ(flip_of(known, answer(known, 2)).value, 0);
  const agent::Node length{named("field_length"), Comparison::less, 0, 0, 8};
  EXPECT_TRUE(std::isnan(flip_of(length, answer(length, 9)).value));
  EXPECT_GT(flip_of(length, answer(length, 9)).threshold, 9);
}

TEST(Flip, AnUnknownValueFlipsByAValueThatPassesAndByNoThreshold) {
  const agent::Node node{named("opponent_distance"), Comparison::less, 0, 0, 0.5f};
  const Flip flip = flip_of(node, answer(node, std::nanf("")));
  EXPECT_LT(flip.value, 0.5f);
  EXPECT_TRUE(std::isnan(flip.threshold));
}

TEST(Flip, YesIsNoAndANameIsAnother) {
  const agent::Node known{named("ball_known"), Comparison::greater, 0, 0, 0.5f};
  EXPECT_EQ(flip_of(known, answer(known, 1)).value, 0);
  EXPECT_EQ(flip_of(known, answer(known, 0)).value, 1);
  const agent::Node role{named("role"), Comparison::equal, 0, 0, 3};
  EXPECT_EQ(flip_of(role, answer(role, 1)).value, 3);
  EXPECT_EQ(flip_of(role, answer(role, 1)).threshold, 1);
  const float other = flip_of(role, answer(role, 3)).value;
  EXPECT_TRUE(other >= 0 && other < 3);
}

TEST(Flip, ANewThresholdStandsInTheConditionToo) {
  agent::Tree tree;
  tree.nodes.push_back({named("ball_distance"), Comparison::less, agent::kLeafBit, agent::kLeafBit, 0.5f});
  tree.node_words.push_back({"tree", "tree", "ball_distance < $near"});
  const agent::Tree changed = with_threshold(tree, 0, 0.75f);
  EXPECT_EQ(changed.nodes[0].threshold, 0.75f);
  EXPECT_EQ(changed.node_words[0].condition, "ball_distance < 0.75 m");
}

}  // namespace
}  // namespace sim::debug
