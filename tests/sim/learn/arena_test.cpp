#include "sim/learn/arena.h"

#include <gtest/gtest.h>

#include <cmath>
#include <set>

#include "robot/core/json_library.h"
#include "sim/drills/trials.h"
#include "sim/io/source.h"
#include "sim/io/strategy.h"
#include "sim/learn/layer.h"
#include "sim/learn/seeds.h"
#include "sim/learn/step.h"
#include "sim/learn/visits.h"

namespace sim::learn {
namespace {

io::Json strategy(const char* name) {
  const auto source = io::find_source("strategies", "strategy", name);
  return *io::flattened(source->text, source->called);
}

const std::vector<std::pair<std::string, double>> kTwoDrills{{"empty_goal", 1}, {"keeper_clears", 3}};

TEST(Arena, PlaysWhatADrillPlays) {
  Ledger ledger;
  Arena arena = *Arena::prepare({{"empty_goal", 1}}, {}, ledger);
  const auto scores = *arena.play(std::vector{strategy("baseline")}, 5, 100);
  const auto trials = *drills::run_trials(*drills::load_drill("empty_goal"), {.trials = 100, .seed = 5});
  EXPECT_EQ(successes_in(scores[0][0]), trials.succeeded);
  EXPECT_NEAR(arena.value_of(scores[0]), trials.score.mean, 1e-6);
}

TEST(Arena, TheNumberOfThreadsAndTheLedgerChangeNothing) {
  Ledger first, second;
  Arena one = *Arena::prepare(kTwoDrills, {.threads = 1}, first),
        three = *Arena::prepare(kTwoDrills, {.threads = 3}, second);
  const std::vector strategies{strategy("baseline"), strategy("kick_now")};
  const auto scores = *one.play(strategies, 1, 70);
  EXPECT_EQ(scores, *three.play(strategies, 1, 70));
  const std::size_t known = first.size();
  EXPECT_EQ(scores, *one.play(strategies, 1, 70));
  EXPECT_EQ(first.size(), known);
  // other seeds, and another world, are other games
  EXPECT_NE(scores, *one.play(strategies, 2, 70));
  Arena robust = *Arena::prepare(kTwoDrills, {.robust = true}, first);
  EXPECT_NE(scores, *robust.play(strategies, 1, 70));
}

TEST(Arena, AGainIsTheWeightedMeanOfPairedDifferences) {
  Ledger ledger;
  const Arena arena = *Arena::prepare(kTwoDrills, {}, ledger);
  const Scores a{{{1, true}, {0, false}}, {{0, false}, {0, false}}}, b{{{2, true}, {0, false}}, {{1, true}, {2, true}}};
  const contest::Mean gain = arena.gain_of(a, b);
  EXPECT_DOUBLE_EQ(gain.mean, (1 * 0.5 + 3 * 1.5) / 4);
  // errors: 0.5 of the first exercise, 0.5 of the second
  EXPECT_DOUBLE_EQ(gain.error, std::sqrt(1 * 0.25 + 9 * 0.25) / 4);
  EXPECT_DOUBLE_EQ(arena.value_of(b) - arena.value_of(a), gain.mean);
  EXPECT_DOUBLE_EQ(success_gain(a[1], b[1]).mean, 1);
}

TEST(Arena, AGameIsPlayedAtHomeAndAwayAgainstEachOpponent) {
  Ledger ledger;
  Arena arena = *Arena::prepare({{kGame, 1}}, {.opponents = {"idle", "kick_now"}}, ledger);
  EXPECT_EQ(arena.attempts_of(0, 32), 8);
  const auto scores = *arena.play(std::vector{strategy("baseline"), strategy("idle")}, 0, 32);
  float baseline = 0, idle = 0;
  for (const Score& score : scores[0][0]) {
    baseline += score.points;
    EXPECT_EQ(score.won, score.points > 0);
  }
  for (const Score& score : scores[1][0]) idle += score.points;
  EXPECT_GT(baseline, 5);
  EXPECT_LT(idle, 0);
}

TEST(Arena, AVisitIsSeenWhereTheAttemptParts) {
  Ledger ledger;
  Arena arena = *Arena::prepare({{"empty_goal", 1}}, {}, ledger);
  const io::Json own = strategy("baseline");
  io::Json other = own;
  // the rule "free" plays something else
  const std::string pointer = "/subtrees/shoot/4";
  ASSERT_EQ(own.at(io::Json::json_pointer(pointer))["name"], "free");
  other.at(io::Json::json_pointer(pointer)) = {{"name", "free"}, {"do", "stand"}};
  const auto scores = *arena.play(std::vector{own, other}, 3, 60);
  const auto visits = *visits_of(own, arena.exercise(0), {"ball_goal_distance"}, 3, 60, 2);
  int visited = 0;
  for (std::size_t i = 0; i < 60; ++i) {
    const auto& moment = visits.at(pointer)[i];
    visited += moment.has_value();
    if (!moment) {
      EXPECT_EQ(scores[0][0][i], scores[1][0][i]) << i;  // never there: the same attempt
    } else {
      EXPECT_GT((*moment)[0], 0);
      EXPECT_LT((*moment)[0], 9);
    }
  }
  EXPECT_GT(visited, 10);
  EXPECT_LT(visited, 60);
}

TEST(Arena, AnUnknownDrillIsNamed) {
  Ledger ledger;
  const auto arena = Arena::prepare({{"empty_gaol", 1}}, {}, ledger);
  ASSERT_FALSE(arena);
  EXPECT_NE(arena.error().find("empty_goal"), std::string::npos) << arena.error();
}

TEST(Arena, EachVariantHasItsPartOfEveryTask) {
  std::multiset<std::size_t> variants;
  for (int i = 0; i < 100; ++i) variants.insert(variant_of(i, 100, 7));
  for (std::size_t v = 0; v < 7; ++v) EXPECT_GE(variants.count(v), 13u);
  EXPECT_EQ(variant_of(0, 100, 7), 0u);
  EXPECT_EQ(variant_of(63, 100, 7), 6u);
  EXPECT_EQ(variant_of(64, 100, 7), 0u);
  EXPECT_EQ(variant_of(99, 100, 7), 6u);
}

TEST(Seeds, OfPurposesAndRunsAreDisjoint) {
  Seeds one(1), next(2);
  const std::uint64_t first = one.take(Purpose::training, 10);
  EXPECT_EQ(one.take(Purpose::training, 5), first + 10);
  EXPECT_EQ(one.used(Purpose::training), 15u);
  std::set<std::uint64_t> firsts;
  for (const Purpose purpose : {Purpose::training, Purpose::held_out, Purpose::selection, Purpose::test})
    for (const Seeds* seeds : {&one, &next}) firsts.insert(seeds->first_of(purpose));
  EXPECT_EQ(firsts.size(), 8u);
  std::uint64_t before = 0;
  for (const std::uint64_t each : firsts) {
    EXPECT_TRUE(before == 0 || each - before >= std::uint64_t{1} << 34);
    before = each;
  }
  EXPECT_LT(Seeds(Seeds::kMostRun).first_of(Purpose::test) + (std::uint64_t{1} << 34), std::uint64_t{1} << 53);
}

TEST(Practice, ShuffledScoresBelongToNobody) {
  Ledger ledger;
  Arena arena = *Arena::prepare({{"empty_goal", 1}}, {}, ledger);
  Seeds seeds(9);
  const std::vector strategies{strategy("baseline"), strategy("idle")};
  const Practice fair{arena, seeds, {}, false}, control{arena, seeds, {}, true};
  const auto plain = *fair.play_on(strategies, 1000, 200), dealt = *control.play_on(strategies, 1000, 200);
  EXPECT_TRUE(is_sure(arena.gain_of(plain[1], plain[0])));
  const contest::Mean gain = arena.gain_of(dealt[1], dealt[0]);
  EXPECT_LT(std::abs(gain.mean), 3 * gain.error);
  EXPECT_EQ(successes_in(plain[0][0]) + successes_in(plain[1][0]),
            successes_in(dealt[0][0]) + successes_in(dealt[1][0]));
}

TEST(Practice, ManyTestsTogetherAskForMore) {
  const contest::Mean gain{.mean = 2.1, .error = 1};
  EXPECT_TRUE(is_sure(gain));
  EXPECT_FALSE(is_sure(gain, 2));
  EXPECT_FALSE(is_sure({.mean = 1, .error = 0}));  // the games were the same
}

}  // namespace
}  // namespace sim::learn
