#include "sim/contest/comparison.h"

#include <gtest/gtest.h>

namespace sim::contest {
namespace {

ComparisonChoice short_games(Metric metric) {
  return {.a = "baseline", .b = "kick_now", .players = 2, .seconds = 60, .metric = metric};
}

Comparison prepared(const ComparisonChoice& choice) {
  auto comparison = Comparison::prepare(choice);
  EXPECT_TRUE(comparison) << comparison.error();
  return *std::move(comparison);
}

compare::Pair pair_of(const Comparison& comparison, std::int64_t number) {
  const auto played = comparison.play(number);
  EXPECT_TRUE(played) << played.error();
  return played->pair;
}

TEST(Comparison, ThePairsOfASeedAreAlwaysTheSame) {
  const ComparisonChoice choice = short_games(Metric::goals);
  const Comparison once = prepared(choice), again = prepared(choice);
  EXPECT_EQ(once.specification(), again.specification());
  for (const std::int64_t number : {3, 0, 3}) EXPECT_EQ(pair_of(once, number), pair_of(again, number));
}

TEST(Comparison, ExchangedBehavioursHaveTheNegatedGain) {
  for (const Metric metric : {Metric::goals, Metric::first_goal, Metric::score_within, Metric::ball_advance}) {
    ComparisonChoice choice = short_games(metric);
    const Comparison direct = prepared(choice);
    std::swap(choice.a, choice.b);
    const Comparison exchanged = prepared(choice);
    for (std::int64_t number = 0; number < 4; ++number) {
      const compare::Pair there = pair_of(direct, number), back = pair_of(exchanged, number);
      // the behaviour that is away in the first game of one pair is away in the second game of the other
      for (const int place : {0, 1}) {
        const compare::GameResult &game = there.games[place], &same_game = back.games[1 - place];
        EXPECT_EQ(game.gain, -same_game.gain) << name_of(metric) << ", pair " << number;
        EXPECT_EQ(game.goals[0], same_game.goals[1]);
        EXPECT_EQ(game.conceded[0], same_game.conceded[1]);
      }
    }
  }
}

TEST(Comparison, ExchangedBehavioursAgainstAThirdHaveTheNegatedGain) {
  ComparisonChoice choice = short_games(Metric::ball_advance);
  choice.opponent = "baseline";
  const Comparison direct = prepared(choice);
  std::swap(choice.a, choice.b);
  const Comparison exchanged = prepared(choice);
  for (std::int64_t number = 0; number < 4; ++number)
    for (const int place : {0, 1})
      EXPECT_EQ(pair_of(direct, number).games[place].gain, -pair_of(exchanged, number).games[place].gain);
}

TEST(Comparison, ABehaviourGainsExactlyNothingOverItself) {
  for (const char* opponent : {"", "kick_now"}) {
    ComparisonChoice choice = short_games(Metric::ball_advance);
    choice.b = choice.a, choice.opponent = opponent;
    const Comparison itself = prepared(choice);
    for (std::int64_t number = 0; number < 4; ++number) {
      const compare::Pair pair = pair_of(itself, number);
      EXPECT_EQ(pair.games[0].gain + pair.games[1].gain, 0) << "against '" << opponent << "', pair " << number;
    }
  }
}

TEST(Comparison, RefusesAMetricThatLacksItsSetting) {
  const auto error_of = [](const ComparisonChoice& choice) {
    const auto comparison = Comparison::prepare(choice);
    return comparison ? "" : comparison.error();
  };
  EXPECT_TRUE(
      error_of({.a = "baseline", .b = "kick_now", .metric = Metric::conceded}).starts_with("metric 'conceded'"));
  EXPECT_EQ(error_of({.a = "baseline", .b = "kick_now", .metric = Metric::score_within}),
            "metric 'score_within' needs a time, such as score_within:30s");
  EXPECT_TRUE(error_of({.a = "baseline", .b = "kick_now", .fuzz = true}).starts_with("--fuzz needs --from"));
}

}  // namespace
}  // namespace sim::contest
