#include "sim/contest/comparison.h"

#include <gtest/gtest.h>

#include <set>

#include "sim/compare/verdict.h"

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
  const auto played = comparison.play(number, 1);
  EXPECT_TRUE(played) << played.error();
  return played->pairs.front();
}

TEST(Comparison, PairsPlayedTogetherAreThosePlayedAlone) {
  for (const char* opponent : {"", "kick_now"})
    for (const Metric metric : {Metric::goals, Metric::first_goal}) {
      ComparisonChoice choice = short_games(metric);
      choice.opponent = opponent;
      const Comparison comparison = prepared(choice);
      const auto together = comparison.play(2, 6);
      ASSERT_TRUE(together) << together.error();
      ASSERT_EQ(together->pairs.size(), 6u);
      for (const std::int64_t number : {2, 4, 7})
        EXPECT_EQ(together->pairs[static_cast<std::size_t>(number - 2)], pair_of(comparison, number)) << number;
    }
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
    std::set<std::uint64_t> hashes;
    for (std::int64_t number = 0; number < 4; ++number) {
      const compare::Pair pair = pair_of(itself, number);
      EXPECT_EQ(pair.games[0].gain + pair.games[1].gain, 0) << "against '" << opponent << "', pair " << number;
      EXPECT_TRUE(pair.same) << "against '" << opponent << "', pair " << number;
      hashes.insert(pair.hash);
    }
    EXPECT_EQ(hashes.size(), 4u) << "each seed has its own games";
  }
}

TEST(Comparison, BehavioursThatActDifferentlyPlayDifferentGamesAlsoWithoutGoals) {
  for (const char* opponent : {"", "baseline"}) {
    const Comparison comparison =
        prepared({.a = "align_first", .b = "kick_now", .opponent = opponent, .situation = "far_free", .seconds = 3});
    for (std::int64_t number = 0; number < 4; ++number) {
      const compare::Pair pair = pair_of(comparison, number);
      EXPECT_EQ(pair.games[0].gain, 0);
      EXPECT_EQ(pair.games[1].gain, 0);
      EXPECT_FALSE(pair.same) << "against '" << opponent << "', pair " << number;
    }
  }
}

TEST(Comparison, WithoutNoiseASeedRepeatsTheGame) {
  const Comparison comparison =
      prepared({.a = "align_first", .b = "kick_now", .models = "perfect", .situation = "near_free", .seconds = 10});
  EXPECT_EQ(pair_of(comparison, 0).hash, pair_of(comparison, 1).hash);
}

TEST(Comparison, OfABehaviourWithItselfExchangesTheMomentForTheOtherLuck) {
  ComparisonChoice choice{.a = "baseline",
                          .b = "baseline",
                          .situation = "close_free",
                          .seconds = 30,
                          .metric = Metric::score_within,
                          .unpaired = true};
  const Comparison itself = prepared(choice);
  choice.unpaired = false;
  const Comparison plain = prepared(choice);
  compare::PairStatistics exchanged, as_given;
  for (std::int64_t number = 0; number < 100; ++number) exchanged.add(pair_of(itself, number));
  for (std::int64_t number = 0; number < 50; ++number) as_given.add(pair_of(plain, number));
  // the striker is at home, so the moment is lopsided
  EXPECT_GT(compare::home_advantage(as_given).low, 0.05);
  const compare::Interval advantage = compare::home_advantage(exchanged);
  EXPECT_LT(advantage.low, 0);
  EXPECT_GT(advantage.high, 0);
  EXPECT_LT(advantage.high - advantage.low, 0.3);
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
