#include "sim/io/condition.h"

#include <gtest/gtest.h>

#include <random>

#include "robot/core/json_library.h"

namespace sim::io {
namespace {

using agent::Comparison;
using agent::Feature;
using agent::FeatureInfo;

const Json kNoParameters = Json::object();

Term only_term(const std::string& text) {
  Values values(kNoParameters);
  const auto condition = parse_condition(text, values);
  EXPECT_TRUE(condition) << text << ": " << condition.error();
  if (!condition) return {};
  EXPECT_EQ(condition->alternatives.size(), 1u) << text;
  EXPECT_EQ(condition->alternatives.front().size(), 1u) << text;
  return condition->alternatives.front().front();
}

bool may_be_compared(const FeatureInfo& a, const FeatureInfo& b) {
  return a.kind == FeatureInfo::Kind::number && b.kind == FeatureInfo::Kind::number &&
         std::string_view(a.unit) == b.unit && a.lateral == b.lateral;
}

Feature random_feature(std::mt19937& random) {
  return static_cast<Feature>(random() % static_cast<unsigned>(agent::feature_count()));
}

/// Returns a feature with which a number may be compared.
Feature random_partner(Feature feature, std::mt19937& random) {
  Feature partner = feature;
  do partner = random_feature(random);
  while (!may_be_compared(info_of(feature), info_of(partner)));
  return partner;
}

/// Makes a random comparison that a tree can have.
Term random_term(std::mt19937& random) {
  const Feature feature = random_feature(random);
  const FeatureInfo& info = info_of(feature);
  Term term{.feature = feature, .comparison = Comparison::less, .threshold = 0.5f, .text = {}};
  if (info.kind == FeatureInfo::Kind::yes_no) {
    term.comparison = random() % 2 ? Comparison::at_most : Comparison::greater;
  } else if (info.kind == FeatureInfo::Kind::name) {
    term.comparison = random() % 2 ? Comparison::equal : Comparison::unequal;
    term.threshold = static_cast<float>(random() % (static_cast<unsigned>(info.most) + 1));
  } else {
    constexpr Comparison kOrders[] = {Comparison::less, Comparison::at_most, Comparison::greater, Comparison::at_least};
    term.comparison = kOrders[random() % 4];
    const Feature other = random_partner(feature, random);
    if (random() % 2)
      term.other = other, term.threshold = 0;
    else
      term.threshold = std::uniform_real_distribution<float>(info.least, info.most)(random);
  }
  return term;
}

TEST(Condition, ItsTextReadsBackIdentically) {
  std::mt19937 random(1);
  for (int i = 0; i < 20000; ++i) {
    const Term term = random_term(random);
    const std::string text = text_of(term);
    const Term back = only_term(text);
    EXPECT_EQ(back.feature, term.feature) << text;
    EXPECT_EQ(back.comparison, term.comparison) << text;
    EXPECT_EQ(back.threshold, term.threshold) << text;
    EXPECT_EQ(back.other, term.other) << text;
    EXPECT_EQ(back.text, text);
    EXPECT_EQ(text_of(back), text);
  }
}

TEST(Condition, NotNegatesAnyComparison) {
  std::mt19937 random(2);
  for (int i = 0; i < 5000; ++i) {
    const Term term = random_term(random);
    const std::string text = text_of(term);
    if (text.starts_with("not ")) continue;
    const Term opposite = only_term("not " + text);
    EXPECT_EQ(opposite.feature, term.feature) << text;
    EXPECT_EQ(opposite.comparison, negated(term.comparison)) << text;
    EXPECT_EQ(opposite.threshold, term.threshold) << text;
    EXPECT_EQ(opposite.other, term.other) << text;
    EXPECT_EQ(opposite.text, "not " + text);
  }
  EXPECT_EQ(text_of(only_term("not ball_age < 2")), "ball_age >= 2 s");
  EXPECT_EQ(text_of(only_term("not role is not keeper")), "role is keeper");
  EXPECT_EQ(text_of(only_term("not x <= ball_x")), "x > ball_x");
}

TEST(Condition, EachPairOfFeaturesIsComparedIfUnitAndSignAgree) {
  int accepted = 0;
  for (int i = 0; i < agent::feature_count(); ++i)
    for (int k = 0; k < agent::feature_count(); ++k) {
      const FeatureInfo &a = info_of(static_cast<Feature>(i)), &b = info_of(static_cast<Feature>(k));
      if (a.kind != FeatureInfo::Kind::number) continue;
      Values values(kNoParameters);
      const std::string text = std::string(a.name) + " < " + b.name;
      const auto condition = parse_condition(text, values);
      EXPECT_EQ(static_cast<bool>(condition), may_be_compared(a, b)) << text;
      accepted += static_cast<bool>(condition);
    }
  EXPECT_GT(accepted, 100);
}

TEST(Condition, NamesTheErrorInAComparisonOfTwoFeatures) {
  const auto refusal = [](std::string_view text) {
    Values values(kNoParameters);
    const auto condition = parse_condition(text, values);
    return condition ? "accepted" : condition.error();
  };
  EXPECT_EQ(refusal("ball_age < ball_distance"), "ball_age and ball_distance must have one unit, got [s] and [m]");
  EXPECT_EQ(refusal("ball_left > ball_ahead"),
            "ball_left and ball_ahead cannot be compared, because only ball_left changes its sign when left and right "
            "are exchanged");
  EXPECT_EQ(refusal("x < role"), "x and role cannot be compared, because both must be numbers");
  EXPECT_EQ(refusal("x < our_kick"), "x and our_kick cannot be compared, because both must be numbers");
  EXPECT_EQ(refusal("role is set_play"),
            "the value for role must be one of keeper, chaser, supporter, defender, got \"set_play\"");
  EXPECT_EQ(refusal("mates_time_to_ball < time_to_bal"),
            "the value for mates_time_to_ball must be 0 .. 1000 [s], got \"time_to_bal\"; did you mean "
            "'time_to_ball'?");
  EXPECT_EQ(refusal("not"), "no feature \"not\"");
  EXPECT_EQ(refusal("not "), "no feature \"not\"");
  EXPECT_EQ(refusal("not not our_kick"), "no feature \"not our_kick\"; did you mean 'our_kick'?");
}

TEST(Condition, AndBindsCloserThanOr) {
  Values values(kNoParameters);
  const auto condition = parse_condition("our_kick and x > 0 or not ball_known", values);
  ASSERT_TRUE(condition) << condition.error();
  ASSERT_EQ(condition->alternatives.size(), 2u);
  EXPECT_EQ(condition->alternatives[0].size(), 2u);
  EXPECT_EQ(condition->alternatives[1].size(), 1u);
}

}  // namespace
}  // namespace sim::io
