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

/// Makes a random comparison that a tree can have.
Term random_term(std::mt19937& random) {
  const auto feature = static_cast<Feature>(random() % static_cast<unsigned>(agent::feature_count()));
  const FeatureInfo& info = info_of(feature);
  Term term{.feature = feature, .comparison = Comparison::less, .threshold = 0.5f, .text = {}};
  if (info.kind == FeatureInfo::Kind::yes_no) {
    term.comparison = random() % 2 ? Comparison::less : Comparison::greater;
  } else if (info.kind == FeatureInfo::Kind::name) {
    term.comparison = random() % 2 ? Comparison::equal : Comparison::unequal;
    term.threshold = static_cast<float>(random() % (static_cast<unsigned>(info.most) + 1));
  } else {
    constexpr Comparison kOrders[] = {Comparison::less, Comparison::at_most, Comparison::greater, Comparison::at_least};
    term.comparison = kOrders[random() % 4];
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
    EXPECT_EQ(back.text, text);
    EXPECT_EQ(text_of(back), text);
  }
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
