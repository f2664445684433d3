#include "robot/fit/kicks/kick_habits.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>
#include <string>

#include "tests/support/simulated_robots.h"
#include "tests/support/temporary_folder.h"

namespace robot::fit {
namespace {

const Figure* habit_in(const std::vector<Figure>& figures, const std::string& name) {
  const auto found = std::ranges::find(figures, name, &Figure::name);
  return found == figures.end() ? nullptr : &*found;
}

/// Kicks of both feet: the left one's go 0.1 rad to the left, the right one's go straight.
KickFit kicks_of(std::size_t each, std::size_t missed) {
  std::mt19937_64 random(1);
  std::normal_distribution<double> normal;
  KickFit fit;
  fit.kind = "long";
  fit.missed = missed;
  fit.status_step = 1 / 30.;
  for (std::size_t i = 0; i < 2 * each; ++i) {
    const bool left = i % 2 == 0;
    fit.kicks.push_back({.left = left, .speed = 1, .direction = (left ? 0.1 : 0) + 0.05 * normal(random)});
    fit.durations.push_back(1.65);
  }
  return fit;
}

TEST(HabitsOf, EachFootHasADirectionOfItsOwn) {
  const auto figures = habits_of(kicks_of(30, 0));
  const Figure *left = habit_in(figures, "kicks.long.direction_left"),
               *right = habit_in(figures, "kicks.long.direction_right");
  ASSERT_TRUE(left && right);
  EXPECT_TRUE(left->low < 0.1 && left->high > 0.1);
  EXPECT_TRUE(right->low < 0 && right->high > 0);
  EXPECT_GT(left->low, right->high);
  const auto few = habits_of(kicks_of(7, 0));
  EXPECT_FALSE(habit_in(few, "kicks.long.direction_left")) << "fewer than 8 kicks";
}

TEST(HabitsOf, TheDurationIsKnownToTheTimeBetweenTwoMessages) {
  const auto figures = habits_of(kicks_of(10, 0));
  const Figure* duration = habit_in(figures, "kicks.long.duration");
  ASSERT_TRUE(duration);
  EXPECT_DOUBLE_EQ(duration->value, 1.65);
  EXPECT_NEAR(duration->high - duration->low, 2 / 30., 1e-9);
  EXPECT_TRUE(duration->is_known());
  KickFit without = kicks_of(10, 0);
  without.durations.resize(4);
  EXPECT_FALSE(habit_in(habits_of(without), "kicks.long.duration")) << "fewer than 5";
}

TEST(HabitsOf, TheShareOfMissesHasWilsonsInterval) {
  const auto never = habits_of(kicks_of(10, 0)), often = habits_of(kicks_of(10, 5));
  const Figure *one = habit_in(never, "kicks.long.missed"), *other = habit_in(often, "kicks.long.missed");
  ASSERT_TRUE(one && other);
  EXPECT_EQ(one->value, 0);
  EXPECT_EQ(one->low, 0);
  EXPECT_NEAR(one->high, 0.161, 0.001);
  EXPECT_DOUBLE_EQ(other->value, 0.2);
  EXPECT_NEAR(other->low, 0.089, 0.001);
  EXPECT_NEAR(other->high, 0.391, 0.001);
}

TEST(HabitsOf, ASimulatedKickLastsAsLongAsTheModelSays) {
  const ::tests::TemporaryFolder folder;
  const Evidence evidence = tests::simulated_robots(folder.path() / "game", {.seconds = 120});
  std::vector<std::string> recordings;
  const KickFacts facts{.kinds = {{.name = "long", .ball_x = 0.19, .ball_y = 0.05, .gate_x = 1, .gate_y = 1}}};
  const auto seen = seen_kicks(evidence, facts, recordings);
  ASSERT_EQ(seen.size(), 1u);
  ASSERT_GE(seen[0].durations.size(), 5u);
  // each is at most one message off; a fall ends a kick earlier
  std::vector<double> durations = seen[0].durations;
  std::ranges::sort(durations);
  EXPECT_NEAR(durations[durations.size() / 2], 1.65, 1 / 30.);
}

}  // namespace
}  // namespace robot::fit
