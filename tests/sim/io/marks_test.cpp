#include "sim/io/marks.h"

#include <gtest/gtest.h>

#include "robot/core/json_library.h"
#include "sim/io/strategy.h"

namespace sim::io {
namespace {

Json parsed(const char* text) { return Json::parse(text); }

std::string error_of(const char* text) {
  const auto cleaned = without_marks(parsed(text));
  return cleaned ? "accepted" : cleaned.error();
}

TEST(Marks, ANumberIsItsValue) {
  EXPECT_EQ(*without_marks(parsed(R"({"parameters": {"near": {"value": "0.5 m", "learn": [0.2, 1.5]}}})")),
            parsed(R"({"parameters": {"near": "0.5 m"}})"));
  // habits and roles are objects themselves
  EXPECT_EQ(*without_marks(parsed(R"({"roles": {"hysteresis": {"value": 1, "unit": "s", "learn": [0, 2]}}})")),
            parsed(R"({"roles": {"hysteresis": {"value": 1, "unit": "s"}}})"));
}

TEST(Marks, RulesAndStrategyLoseThem) {
  EXPECT_EQ(*without_marks(parsed(R"({"learn": {"conditions": ["ball_x"]},
      "tree": [{"if": "ball_known", "do": "kick", "learn": [{"do": "dribble"}]}, {"do": "stand"}]})")),
            parsed(R"({"tree": [{"if": "ball_known", "do": "kick"}, {"do": "stand"}]})"));
}

TEST(Marks, WithoutMarksNothingChanges) {
  const Json plain =
      parsed(R"({"tree": [[{"if": "ball_known", "do": "kick", "with": {"range": 3}}], {"do": "stand"}]})");
  EXPECT_EQ(*without_marks(plain), plain);
}

TEST(Marks, WrongOnesAreNamed) {
  EXPECT_EQ(error_of(R"({"parameters": {"near": {"value": 1, "learn": [2, 1]}}})"),
            "parameters.near.learn must be a range [least, most], got [2,1]");
  EXPECT_EQ(error_of(R"({"parameters": {"near": {"value": 1, "learn": [1]}}})"),
            "parameters.near.learn must be a range [least, most], got [1]");
  EXPECT_EQ(error_of(R"({"tree": [{"do": "kick", "learn": []}]})"),
            "tree[0].learn must be a list of rules with 'do', got []");
  EXPECT_EQ(error_of(R"({"tree": [{"use": "x", "learn": [{"do": "kick"}]}]})").substr(0, 60),
            "tree[0].learn must be beside a value, or beside 'do' in a ru");
  EXPECT_EQ(error_of(R"({"learn": ["ball_x"]})"), "learn must be {\"conditions\": [features]}, got [\"ball_x\"]");
  EXPECT_NE(error_of(R"({"learn": {"conditions": ["bal_x"]}})").find("learn.conditions: "), std::string::npos);
}

TEST(Marks, AMarkedStrategyPlaysLikeAPlainOne) {
  const char* const marked = R"({"name": "m", "parameters": {"near": {"value": "0.5 m", "learn": [0.2, 1.5]}},
      "learn": {"conditions": ["ball_x"]},
      "tree": [{"if": "ball_distance < $near", "do": "kick", "with": {"range": {"value": 3, "learn": [1, 5]}},
                "learn": [{"do": "dribble"}]}, {"do": "search_ball"}]})";
  const auto tree = parse_strategy(marked, "strategy 'm'");
  ASSERT_TRUE(tree) << tree.error();
  EXPECT_FLOAT_EQ(tree->nodes[0].threshold, 0.5f);
  EXPECT_EQ(tree->leaves.size(), 2u);
  const auto wrong = parse_strategy(R"({"name": "m", "learn": 1, "tree": {"do": "stand"}})", "strategy 'm'");
  ASSERT_FALSE(wrong);
  EXPECT_EQ(wrong.error(), "strategy 'm': learn must be {\"conditions\": [features]}, got 1");
}

TEST(Marks, AFlattenedStrategyHasThoseOfItsBase) {
  const auto flat = flattened(R"({"name": "mine", "based_on": "baseline",
      "parameters": {"near_ball": {"value": "0.6 m", "learn": [0.2, 1]}}})",
                              "strategy 'mine'");
  ASSERT_TRUE(flat) << flat.error();
  EXPECT_FALSE(flat->contains("based_on"));
  EXPECT_EQ((*flat)["parameters"]["near_ball"]["value"], "0.6 m");
  EXPECT_TRUE((*flat)["subtrees"].contains("chaser"));
  const auto read = parse_strategy(flat->dump(), "flat");
  EXPECT_TRUE(read) << read.error();
}

}  // namespace
}  // namespace sim::io
