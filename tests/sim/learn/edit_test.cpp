#include "sim/learn/edit.h"

#include <gtest/gtest.h>

#include "robot/core/json_library.h"
#include "sim/io/strategy.h"

namespace sim::learn {
namespace {

using io::Json;

const Json kTree = Json::parse(R"({
  "name": "small",
  "parameters": {"near": "0.5 m", "far": "3 m"},
  "tree": [
    {"if": "not ball_known", "do": "search_ball"},
    {"name": "close", "if": "ball_distance < $near", "do": "kick", "with": {"range": "$far"}, "else": {"do": "walk_to_ball"}}
  ]
})");
const Json kOther = Json::parse(R"([
  {"if": "not ball_known", "do": "search_ball"},
  {"name": "never", "if": "ball_age > 5", "do": "dribble"},
  {"use": "rest"}
])");

Layer kicks() {
  return {.name = "kick",
          .about = "",
          .skills = {"kick", "dribble"},
          .leaves = {"kick", "dribble"},
          .features = {},
          .conditions = {},
          .actions = {R"({"do": "dribble"})", R"({"do": "kick", "with": {"range": "$far"}})"},
          .exercises = {}};
}

void expect_plays(const Json& strategy) {
  const auto tree = io::parse_strategy(strategy.dump(), "changed");
  EXPECT_TRUE(tree) << tree.error();
}

TEST(Edit, LeavesHaveTheActionsOfTheLayerWithoutTheirOwn) {
  const auto leaves = leaves_of(kTree, kicks());
  ASSERT_EQ(leaves.size(), 1u);
  EXPECT_EQ(leaves[0].pointer, "/tree/1");
  ASSERT_EQ(leaves[0].alternatives.size(), 1u);
  EXPECT_EQ(leaves[0].alternatives[0]["do"], "dribble");
}

TEST(Edit, AMarkedLeafHasItsOwnActions) {
  Json marked = kTree;
  marked["tree"][1]["learn"] = Json::parse(R"([{"do": "align"}, {"do": "pass"}])");
  const auto leaves = leaves_of(marked, kicks());
  ASSERT_EQ(leaves.size(), 1u);
  EXPECT_EQ(leaves[0].alternatives.size(), 2u);
  expect_plays(marked);
}

TEST(Edit, AnotherActionTakesItsUnusedParametersAlong) {
  const Json changed = with_action(kTree, "/tree/1", {{"do", "dribble"}});
  EXPECT_EQ(changed["tree"][1]["do"], "dribble");
  EXPECT_FALSE(changed["tree"][1].contains("with"));
  EXPECT_FALSE(changed["parameters"].contains("far"));
  EXPECT_TRUE(changed["parameters"].contains("near"));
  expect_plays(changed);
}

TEST(Edit, ASplitStandsWithinTheConditionOfItsLeaf) {
  const Json split = with_split(kTree, "/tree/1", "opponent_ball_distance < 0.8 m", {{"do", "dribble"}});
  const Json& rule = split["tree"][1];
  EXPECT_EQ(rule["if"], "ball_distance < $near");
  EXPECT_EQ(rule["then"][0]["if"], "opponent_ball_distance < 0.8 m");
  EXPECT_EQ(rule["then"][0]["do"], "dribble");
  EXPECT_EQ(rule["then"][1]["do"], "kick");
  EXPECT_EQ(rule["else"]["do"], "walk_to_ball");
  expect_plays(split);
}

TEST(Edit, ALeafWithoutConditionIsSplitByARuleBeforeIt) {
  const Json split = with_split(kTree, "/tree/1/else", "ball_x > 0", {{"do", "dribble"}});
  EXPECT_EQ(split["tree"][1]["else"][0]["do"], "dribble");
  EXPECT_EQ(split["tree"][1]["else"][1]["do"], "walk_to_ball");
  expect_plays(split);
}

TEST(Edit, OnlyARuleThatAnotherFollowsCanGo) {
  Json tree = kTree;
  tree["tree"] = kOther;
  tree["subtrees"] = Json::parse(
      R"({"rest": [{"if": "ball_distance < $near", "do": "kick", "with": {"range": "$far"}}, {"do": "dribble"}]})");
  const auto spare = spare_rules(tree, kicks());
  ASSERT_EQ(spare.size(), 2u);
  EXPECT_EQ(spare[0].pointer, "/tree/1");
  EXPECT_EQ(spare[1].pointer, "/subtrees/rest/0");
  for (const SpareRule& rule : spare) expect_plays(without_rule(tree, rule.pointer));
}

TEST(Edit, UnusedSubtreesGoWithTheSubtreesThatOnlyTheyUsed) {
  Json tree = kTree;
  tree["subtrees"] = Json::parse(R"({"a": {"use": "b"}, "b": {"do": "stand"}})");
  const Json cleaned = without_unused(tree);
  EXPECT_TRUE(cleaned["subtrees"].empty());
  EXPECT_EQ(cleaned["parameters"], kTree["parameters"]);
}

TEST(Edit, AnActionIsToldInWords) {
  EXPECT_EQ(words_of(Json::parse(R"({"do": "kick", "with": {"aim": "goal", "care": 0.5}})")),
            "kick (aim goal, care 0.5)");
  EXPECT_EQ(words_of({{"do", "dribble"}}), "dribble");
}

}  // namespace
}  // namespace sim::learn
