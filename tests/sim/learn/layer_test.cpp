#include "sim/learn/layer.h"

#include <gtest/gtest.h>

#include "sim/io/source.h"

namespace sim::learn {
namespace {

TEST(Layer, AllEmbeddedLayersAreRead) {
  for (const std::string_view name : io::names_of("layers")) {
    const auto layer = load_layer(std::string(name));
    ASSERT_TRUE(layer) << layer.error();
    EXPECT_FALSE(layer->skills.empty());
    EXPECT_FALSE(layer->exercises.empty());
  }
}

TEST(Layer, AKnobBelongsToItBySkillOrFeature) {
  const Layer layer =
      *parse_layer(R"({"skills": ["kick"], "features": ["ball_age"], "exercises": {"corner": 1}})", "layer", "x");
  EXPECT_TRUE(layer.has({.name = "", .place = "", .skills = {"kick"}, .features = {}}));
  EXPECT_TRUE(layer.has({.name = "", .place = "", .skills = {"pass"}, .features = {"ball_age"}}));
  EXPECT_FALSE(layer.has({.name = "", .place = "", .skills = {"pass"}, .features = {"ball_x"}}));
}

TEST(Layer, LeavesThatMayChangeAreThoseOfItsSkillsUnlessItNamesOthers) {
  const Layer own = *parse_layer(R"({"skills": ["kick"], "exercises": {"corner": 1}})", "layer", "x");
  EXPECT_EQ(own.leaves, own.skills);
  const Layer other =
      *parse_layer(R"({"skills": ["pass"], "leaves": ["kick"], "exercises": {"corner": 1}})", "layer", "x");
  EXPECT_EQ(other.leaves, std::vector<std::string>{"kick"});
}

TEST(Layer, ASeamHasTheNumbersOfBoth) {
  const Layer lower = *load_layer("kick"), upper = *load_layer("role"), seam = seam_of(lower, upper);
  EXPECT_EQ(seam.name, "kick and role");
  EXPECT_EQ(seam.skills.size(), lower.skills.size() + upper.skills.size());
  EXPECT_TRUE(seam.actions.empty());
  EXPECT_EQ(seam.exercises.front().first, kGame);
}

TEST(Layer, AWrongOneIsRefusedInASentence) {
  const auto error = [](const char* text) {
    const auto layer = parse_layer(text, "layer 'x'", "x");
    return layer ? std::string("read") : layer.error();
  };
  EXPECT_NE(error(R"({"skills": ["kik"], "exercises": {"corner": 1}})").find("layer 'x': skills[0]: "),
            std::string::npos);
  EXPECT_EQ(error(R"({"skills": "kick", "exercises": {"corner": 1}})"),
            "layer 'x': skills must be a list of names, got \"kick\"");
  EXPECT_NE(error(R"({"skills": [1], "exercises": {"corner": 1}})").find("skills[0] must be a text, got 1"),
            std::string::npos);
  for (const char* wrong : {R"({})", R"({"exercises": {}})", R"({"exercises": {"corner": 0}})", R"({"exercises": 3})"})
    EXPECT_EQ(error(wrong), "layer 'x': exercises must be an object of drills and their weights above 0") << wrong;
  EXPECT_NE(error(R"({"actions": [3], "exercises": {"corner": 1}})").find("actions must be a list of rules with 'do'"),
            std::string::npos);
  EXPECT_NE(error(R"({"drills": 1, "exercises": {"corner": 1}})").find("drills"), std::string::npos);
}

}  // namespace
}  // namespace sim::learn
