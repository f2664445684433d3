#include "sim/agent/tree.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "sim/agent/trace.h"
#include "tests/sim/agent/scene.h"

namespace sim::agent {
namespace {

TEST(Tree, TheTraceHasThePathAndTheComparedValues) {
  const TreeBehaviour behaviour(tree_of(R"({
    "name": "traced",
    "parameters": { "near": "0.5 m" },
    "tree": [
      { "if": "not ball_known", "do": "search_ball" },
      { "name": "close", "if": "ball_distance < $near and ball_age < 1", "use": "strike" },
      { "if": "pass_gain > 0 or ball_x > 0.5", "do": "walk_to_ball", "with": { "distance": "40 cm" } },
      { "do": "stand" }
    ],
    "subtrees": { "strike": { "do": "kick" } }
  })"));
  Scene scene;
  Trace trace;
  scene.decide(behaviour, &trace);
  ASSERT_EQ(trace.visited.size(), 5u);
  EXPECT_STREQ(trace.visited[0].path, "traced/not ball_known");
  EXPECT_STREQ(trace.visited[0].condition, "not ball_known");
  EXPECT_FALSE(trace.visited[0].result);
  EXPECT_STREQ(trace.visited[1].name, "close");
  EXPECT_STREQ(trace.visited[1].condition, "ball_distance < $near");
  EXPECT_EQ(trace.visited[1].value, 1);
  EXPECT_EQ(trace.visited[1].threshold, 0.5f);
  EXPECT_FALSE(trace.visited[2].known);
  EXPECT_FALSE(trace.visited[2].result);
  EXPECT_STREQ(trace.visited[3].feature, "ball_x");
  EXPECT_TRUE(trace.visited[3].result);
  EXPECT_STREQ(trace.visited[4].path, "traced/pass_gain > 0 or ball_x > 0.5/walk_to_ball");
  EXPECT_STREQ(trace.skill, "walk_to_ball");
  EXPECT_STREQ(trace.role, "chaser");
  ASSERT_EQ(trace.arguments.size(), 4u);
  EXPECT_STREQ(trace.arguments[2].name, "distance");
  EXPECT_FLOAT_EQ(trace.arguments[2].value, 0.4f);

  scene.see_ball({0.3f, 0});
  scene.decide(behaviour, &trace);
  EXPECT_STREQ(trace.visited.back().path, "traced/close/strike/kick");
}

/// The reasons of a decision, and the memory after it.
struct Decided {
  Trace trace;
  Mind mind;
};

/// Decides. The scene stays as it was, but for the values that the decision changed before it used them.
Decided decide(Scene& scene, const TreeBehaviour& behaviour) {
  Scene after = scene;
  Decided decided;
  after.decide(behaviour, &decided.trace);
  decided.mind = after.mind;
  scene.mind.role = after.mind.role, scene.mind.time_to_ball_cs = after.mind.time_to_ball_cs;
  return decided;
}

TEST(Tree, ValuesInTheTraceEqualTheFeaturesAndLeadToTheTracedLeaf) {
  const TreeBehaviour behaviour(shipped("passing"));
  std::mt19937 random(1);
  for (int n = 0; n < 2000; ++n) {
    Scene scene = random_scene(random);
    const auto [trace, mind] = decide(scene, behaviour);
    const View view = scene.view();
    for (std::size_t i = 0; i + 1 < trace.visited.size(); ++i) {
      const Trace::Node& node = trace.visited[i];
      const float value = value_of(find_feature(node.feature), view);
      EXPECT_EQ(node.known, !std::isnan(value));
      EXPECT_TRUE(node.known ? node.value == value : !node.result) << node.condition;
    }
    ASSERT_FALSE(trace.visited.empty());
    EXPECT_EQ(behaviour.tree().leaf_words[mind.leaf].path, trace.visited.back().path);
    EXPECT_STREQ(info_of(behaviour.tree().leaves[mind.leaf].skill).name, trace.skill);
  }
}

TEST(Tree, UnknownValuesNeverPass) {
  const float unknown = std::numeric_limits<float>::quiet_NaN();
  for (const auto comparison : {Comparison::less, Comparison::at_most, Comparison::greater, Comparison::at_least,
                                Comparison::equal, Comparison::unequal})
    EXPECT_FALSE(holds(comparison, unknown, 0));
}

TEST(Tree, UnknownThresholdsNeverPass) {
  const float unknown = std::numeric_limits<float>::quiet_NaN();
  for (const auto comparison : {Comparison::less, Comparison::at_most, Comparison::greater, Comparison::at_least,
                                Comparison::equal, Comparison::unequal})
    EXPECT_FALSE(holds(comparison, 0, unknown));
}

TEST(Tree, ANegatedComparisonPassesAllKnownValuesThatTheComparisonDoesNot) {
  const float unknown = std::numeric_limits<float>::quiet_NaN();
  for (const auto comparison : {Comparison::less, Comparison::at_most, Comparison::greater, Comparison::at_least,
                                Comparison::equal, Comparison::unequal}) {
    for (const float a : {-1.f, 0.f, 2.f})
      for (const float b : {-1.f, 0.f, 2.f}) EXPECT_NE(holds(comparison, a, b), holds(negated(comparison), a, b));
    EXPECT_FALSE(holds(negated(comparison), unknown, 0));
    EXPECT_EQ(negated(negated(comparison)), comparison);
  }
}

TEST(Tree, TwoFeaturesAreComparedByTheirValuesWhichTheTraceHas) {
  const TreeBehaviour behaviour(tree_of(R"({"name": "two", "tree": [
    {"if": "mates_time_to_ball < time_to_ball", "do": "position"},
    {"if": "not ball_ahead <= ball_off_centre", "do": "walk_to_ball"},
    {"do": "stand"}]})"));
  const Feature mates = find_feature("mates_time_to_ball"), own = find_feature("time_to_ball"),
                ahead = find_feature("ball_ahead"), off_centre = find_feature("ball_off_centre");
  const float unknown = std::numeric_limits<float>::quiet_NaN();
  int reached[3] = {};
  std::mt19937 random(4);
  for (int n = 0; n < 3000; ++n) {
    Scene scene = random_scene(random);
    const auto [trace, mind] = decide(scene, behaviour);
    const View view = scene.view();
    const auto same = [&](float value, float expected) {
      return value == expected || (std::isnan(value) && std::isnan(expected));
    };
    ASSERT_GE(trace.visited.size(), 2u);
    EXPECT_STREQ(trace.visited[0].condition, "mates_time_to_ball < time_to_ball");
    EXPECT_STREQ(trace.visited[0].feature, "mates_time_to_ball");
    EXPECT_TRUE(same(trace.visited[0].value, value_of(mates, view)));
    EXPECT_TRUE(same(trace.visited[0].threshold, value_of(own, view)));
    EXPECT_EQ(trace.visited[0].result, value_of(mates, view) < value_of(own, view));
    if (trace.visited.size() == 3) {
      EXPECT_TRUE(same(trace.visited[1].threshold, value_of(off_centre, view)));
      EXPECT_EQ(trace.visited[1].result, value_of(ahead, view) > value_of(off_centre, view));
    }
    ++reached[std::string_view(trace.skill) == "position"       ? 0
              : std::string_view(trace.skill) == "walk_to_ball" ? 1
                                                                : 2];
  }
  for (const int count : reached) EXPECT_GT(count, 100);
  EXPECT_FALSE(holds(Comparison::less, unknown, unknown));
}

TEST(Tree, ComparisonsDoWhatTheirNamesSay) {
  for (const float a : {-1.f, 0.f, 2.f})
    for (const float b : {-1.f, 0.f, 2.f}) {
      EXPECT_EQ(holds(Comparison::less, a, b), a < b);
      EXPECT_EQ(holds(Comparison::at_most, a, b), a <= b);
      EXPECT_EQ(holds(Comparison::greater, a, b), a > b);
      EXPECT_EQ(holds(Comparison::at_least, a, b), a >= b);
      EXPECT_EQ(holds(Comparison::equal, a, b), a == b);
      EXPECT_EQ(holds(Comparison::unequal, a, b), a != b);
    }
}

TEST(Tree, RemembersTheLeafAndSinceWhen) {
  const TreeBehaviour behaviour(shipped("baseline"));
  Scene scene;
  scene.decide(behaviour);
  const Tick since = scene.mind.leaf_since;
  EXPECT_EQ(since, scene.now);
  const std::uint16_t leaf = scene.mind.leaf;
  scene.now += 3;
  scene.see_ball({1, 0});
  scene.decide(behaviour);
  EXPECT_EQ(scene.mind.leaf, leaf);
  EXPECT_EQ(scene.mind.leaf_since, since);
  scene.beliefs.ball.seen = kNever;
  scene.decide(behaviour);
  EXPECT_NE(scene.mind.leaf, leaf);
  EXPECT_EQ(scene.mind.leaf_since, scene.now);
}

}  // namespace
}  // namespace sim::agent
