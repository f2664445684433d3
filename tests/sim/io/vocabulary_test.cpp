#include "sim/io/vocabulary.h"

#include <gtest/gtest.h>

#include <set>

#include "robot/core/json_library.h"
#include "sim/io/condition.h"
#include "sim/io/strategy.h"

namespace sim::io {
namespace {

using agent::Feature;
using agent::FeatureInfo;
using agent::ParameterInfo;
using agent::Skill;
using agent::SkillInfo;

template <class Check>
void for_each_skill(Check&& check) {
  for (int i = 0; i < agent::skill_count(); ++i) {
    SCOPED_TRACE(info_of(static_cast<Skill>(i)).name);
    check(static_cast<Skill>(i), info_of(static_cast<Skill>(i)));
  }
}
template <class Check>
void for_each_feature(Check&& check) {
  for (int i = 0; i < agent::feature_count(); ++i) {
    SCOPED_TRACE(info_of(static_cast<Feature>(i)).name);
    check(static_cast<Feature>(i), info_of(static_cast<Feature>(i)));
  }
}

TEST(Vocabulary, EverySkillArgumentAndFeatureHasADescription) {
  for_each_skill([](Skill, const SkillInfo& info) {
    EXPECT_STRNE(info.about, "");
    for (int i = 0; i < info.count; ++i) {
      const ParameterInfo& parameter = info.parameters[i];
      EXPECT_STRNE(parameter.about, "") << parameter.name;
      EXPECT_LT(parameter.range.least, parameter.range.most) << parameter.name;
      // NaN for an optional argument
      EXPECT_FALSE(parameter.standard < parameter.range.least) << parameter.name;
      EXPECT_FALSE(parameter.standard > parameter.range.most) << parameter.name;
    }
  });
  for_each_feature([](Feature, const FeatureInfo& info) {
    EXPECT_STRNE(info.about, "");
    EXPECT_LT(info.least, info.most);
  });
}

TEST(Vocabulary, NoWordOccursTwice) {
  std::set<std::string> words;
  for_each_skill([&](Skill, const SkillInfo& info) { EXPECT_TRUE(words.insert(info.name).second); });
  words.clear();
  for_each_feature([&](Feature, const FeatureInfo& info) { EXPECT_TRUE(words.insert(info.name).second); });
}

TEST(Vocabulary, TheExampleOfASkillIsATreeWithTheDefaultsOfItsArguments) {
  for_each_skill([](Skill skill, const SkillInfo& info) {
    const auto tree = parse_strategy(R"({"name": "m", "tree": )" + example_of(skill) + "}", "strategy 'm'");
    ASSERT_TRUE(tree) << tree.error();
    ASSERT_EQ(tree->leaves.size(), 1u);
    EXPECT_EQ(tree->leaves[0].skill, skill);
    for (int i = 0; i < info.count; ++i) {
      const float argument = tree->leaves[0].arguments[i], standard = info.parameters[i].standard;
      EXPECT_EQ(agent::is_given(argument), agent::is_given(standard));
      if (agent::is_given(standard)) {
        EXPECT_EQ(argument, standard);
      }
    }
  });
}

TEST(Vocabulary, TheExampleOfAnArgumentIsReadBack) {
  for_each_skill([](Skill skill, const SkillInfo& info) {
    const Json json = json_of(skill);
    for (int i = 0; i < info.count; ++i) {
      const std::string example = json["arguments"][static_cast<std::size_t>(i)]["example"];
      const auto tree = parse_strategy(
          R"({"name": "m", "tree": {"do": ")" + std::string(info.name) + R"(", "with": {)" + example + "}}}", "'m'");
      ASSERT_TRUE(tree) << tree.error();
      EXPECT_TRUE(agent::is_given(tree->leaves[0].arguments[i])) << example;
      EXPECT_NE(text_of(skill).find(example), std::string::npos) << example;
    }
  });
}

TEST(Vocabulary, TheExampleOfAFeatureIsAConditionThatComparesIt) {
  const Json nothing = Json::object();
  for_each_feature([&](Feature feature, const FeatureInfo& info) {
    Values values(nothing);
    const auto condition = parse_condition(example_of(feature), values);
    ASSERT_TRUE(condition) << condition.error();
    const Term& term = condition->alternatives.at(0).at(0);
    EXPECT_EQ(term.feature, feature);
    // the comparison must depend on the value
    if (info.kind == FeatureInfo::Kind::number) {
      EXPECT_GT(term.threshold, info.least);
      EXPECT_LT(term.threshold, info.most);
    }
  });
  EXPECT_EQ(example_of(agent::find_feature("ball_distance")), "ball_distance < 0.5 m");
  EXPECT_EQ(example_of(agent::find_feature("ball_known")), "ball_known");
  EXPECT_EQ(example_of(agent::find_feature("role")), "role is keeper");
}

TEST(Vocabulary, WordsAreDescribedWithAllThatTheirTablesHold) {
  for_each_skill([](Skill skill, const SkillInfo& info) {
    const Json json = json_of(skill);
    const std::string text = text_of(skill);
    EXPECT_EQ(json["name"], info.name);
    EXPECT_EQ(json["example"], example_of(skill));
    ASSERT_EQ(json["arguments"].size(), static_cast<std::size_t>(info.count));
    for (int i = 0; i < info.count; ++i) {
      const ParameterInfo& parameter = info.parameters[i];
      const Json& argument = json["arguments"][static_cast<std::size_t>(i)];
      EXPECT_EQ(argument["name"], parameter.name);
      EXPECT_TRUE(argument.contains("default"));
      EXPECT_TRUE(argument.contains(parameter.range.names ? "values" : "unit"));
      EXPECT_NE(text.find(parameter.about), text.npos);
    }
  });
  for_each_feature([](Feature feature, const FeatureInfo& info) {
    const Json json = json_of(feature);
    EXPECT_EQ(json["name"], info.name);
    EXPECT_EQ(json["needs_ball"], info.needs_ball);
    EXPECT_EQ(json["example"], example_of(feature));
    for (const std::string& part : {std::string(info.name), std::string(info.about), example_of(feature)})
      EXPECT_NE(text_of(feature).find(part), std::string::npos) << part;
  });
}

TEST(Vocabulary, SaysWhichWordsAreTheTeamsOwn) {
  EXPECT_EQ(json_of(agent::find_skill("shadow"))["own"], true);
  EXPECT_EQ(json_of(agent::find_skill("kick"))["own"], false);
  EXPECT_EQ(json_of(agent::find_feature("mates_ahead"))["own"], true);
  EXPECT_EQ(json_of(agent::find_feature("ball_age"))["own"], false);
}

TEST(Vocabulary, AnUnknownWordIsRefusedWithASimilarOne) {
  EXPECT_EQ(skill_named("kick").value(), agent::find_skill("kick"));
  EXPECT_EQ(skill_named("kik").error(), "no skill \"kik\"; did you mean 'kick'?");
  EXPECT_EQ(feature_named("ball_age").value(), agent::find_feature("ball_age"));
  EXPECT_EQ(feature_named("ball_agee").error(), "no feature \"ball_agee\"; did you mean 'ball_age'?");
}

}  // namespace
}  // namespace sim::io
