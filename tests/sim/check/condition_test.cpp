#include "sim/check/condition.h"

#include <gtest/gtest.h>

#include "tests/sim/check/course.h"

namespace sim::check {
namespace {

/// Returns whether the condition holds after our touches at these times [s], up to 20 s.
bool holds_after(std::string_view text, const std::vector<float>& touches) {
  const auto condition = parse_condition(text);
  EXPECT_TRUE(condition) << text << ": " << condition.error();
  if (!condition) return false;
  Watch watch(*condition);
  Course course;
  const auto see = [&](const Glance& glance) { watch.see(glance); };
  for (const float time : touches) {
    course.wait(time - static_cast<float>(course.now().world.tick) * kTickDuration, see);
    course.touch(Side::home, 2, see);
  }
  course.wait(20 - static_cast<float>(course.now().world.tick) * kTickDuration, see);
  return watch.holds();
}

std::string refused_condition(std::string_view text) {
  const auto condition = parse_condition(text);
  return condition ? "accepted" : condition.error();
}

TEST(Condition, ASequenceHoldsIfItsFactsComeTrueInThisOrder) {
  EXPECT_FALSE(holds_after("our touch", {}));
  EXPECT_TRUE(holds_after("our touch", {3}));
  EXPECT_TRUE(holds_after("eventually our touch", {3}));
  EXPECT_FALSE(holds_after("our touch then our touch", {3}));
  EXPECT_TRUE(holds_after("our touch then our touch", {3, 15}));
  EXPECT_FALSE(holds_after("our touch then their touch", {3, 15}));
}

TEST(Condition, WithinLimitsTheTimeSinceTheFactBeforeOrSinceTheStart) {
  constexpr std::string_view kTwo = "our touch then our touch within 5 s";
  EXPECT_TRUE(holds_after(kTwo, {3, 7}));
  EXPECT_FALSE(holds_after(kTwo, {3, 9}));
  EXPECT_TRUE(holds_after(kTwo, {1, 8, 12}));  // the last two
  EXPECT_FALSE(holds_after(kTwo, {1, 8, 15}));
  EXPECT_TRUE(holds_after("our touch within 4 s", {3}));
  EXPECT_FALSE(holds_after("our touch within 4 s", {5}));
  EXPECT_TRUE(holds_after("our touch then our touch within 5 s then our touch within 5 s", {1, 8, 12, 16}));
  EXPECT_FALSE(holds_after("our touch then our touch within 5 s then our touch within 5 s", {1, 5, 12, 16}));
}

TEST(Condition, AlwaysAndNeverAreAboutEveryTick) {
  EXPECT_TRUE(holds_after("never our touch", {}));
  EXPECT_FALSE(holds_after("never our touch", {3}));
  EXPECT_TRUE(holds_after("not our touch", {}));
  EXPECT_TRUE(holds_after("always ball_x < 1 m", {3}));
  EXPECT_FALSE(holds_after("always ball_x > 1 m", {3}));
  EXPECT_TRUE(holds_after("not always ball_x > 1 m", {3}));
  EXPECT_TRUE(holds_after("never ball_x > 1", {}));
}

TEST(Condition, AndBindsCloserThanOr) {
  for (const bool a : {false, true})
    for (const bool b : {false, true})
      for (const bool c : {false, true}) {
        const auto word = [](bool is_true) { return std::string(is_true ? "never" : "eventually") + " their goal"; };
        const std::string text = word(a) + " or " + word(b) + " and " + word(c);
        EXPECT_EQ(holds_after(text, {}), a || (b && c)) << text;
      }
}

TEST(Condition, UnknownQuantitiesNeverPass) {
  const auto condition = parse_condition("our_ball_distance > 0 or our_ball_distance <= 30");
  ASSERT_TRUE(condition) << condition.error();
  Watch watch(*condition);
  Course course;
  for (int player = 1; player <= 4; ++player)
    course.now().world.bodies[robot_of(Side::home, player)].doing = Body::Doing::removed;
  course.wait(1, [&](const Glance& glance) { watch.see(glance); });
  EXPECT_FALSE(watch.holds());
}

TEST(Condition, NamesTheError) {
  EXPECT_EQ(refused_condition("our tuch"),
            "expected a happening or a quantity, got \"our tuch\"; did you mean 'our touch'?");
  EXPECT_EQ(refused_condition("bal_x > 1"),
            "expected a happening or a quantity, got \"bal_x > 1\"; did you mean 'ball_x'?");
  EXPECT_EQ(
      refused_condition("").find("expected a happening or a quantity, got \"\"; there are: our touch, their touch, "),
      0u);
  EXPECT_EQ(refused_condition("ball_x"), "ball_x is compared by < <= > >=, got \"\"");
  EXPECT_EQ(refused_condition("ball_x > 99"), "the value for ball_x must be -15 .. 15 [m], got \"99\"");
  EXPECT_EQ(refused_condition("ball_x > 1 s"), "expected 'and', 'or', 'then' or 'within', got \"s\"");
  EXPECT_EQ(refused_condition("our touch within 5 m"), "expected 'and', 'or', 'then' or 'within', got \"m\"");
  EXPECT_EQ(refused_condition("our touch within soon"), "the time behind 'within' must be 0 .. 3600 [s], got \"soon\"");
  EXPECT_EQ(refused_condition("always our touch then our goal"),
            "'always' takes one fact, without 'then' and 'within'");
  EXPECT_EQ(refused_condition("our touch our goal"), "expected 'and', 'or', 'then' or 'within', got \"our goal\"");
  EXPECT_EQ(refused_condition(std::string(2000, 'x')), "must have at most 1000 bytes, got 2000");
}

TEST(Condition, EveryTruncationIsAcceptedOrRefusedWithASentence) {
  constexpr std::string_view kText =
      "not always ball_x > 1 m and our touch then our touch within 5 s or never their goal";
  EXPECT_EQ(refused_condition(kText), "accepted");
  for (std::size_t size = 0; size < kText.size(); ++size)
    EXPECT_NE(refused_condition(kText.substr(0, size)), "") << size;
}

}  // namespace
}  // namespace sim::check
