#include "sim/environment/environment.h"

#include <gtest/gtest.h>

#include <bit>
#include <cmath>
#include <numeric>

#include "robot/core/json_library.h"
#include "sim/io/json.h"
#include "sim/match/hash.h"
#include "tests/sim/support/allocations.h"

namespace sim::environment {
namespace {

using Games = std::unique_ptr<Environment>;

Games opened(const std::string& options) {
  auto games = Environment::open(options);
  EXPECT_TRUE(games) << games.error();
  return *std::move(games);
}

std::vector<std::uint64_t> seeds_from(std::uint64_t first, int count) {
  std::vector<std::uint64_t> seeds(static_cast<std::size_t>(count));
  std::iota(seeds.begin(), seeds.end(), first);
  return seeds;
}

/// Writes random actions that depend on `number` and on nothing else.
void act_at_random(Environment& games, std::uint32_t number, Kind kind, int rules) {
  std::vector<float>& actions = games.arrays().actions;
  for (std::size_t i = 0; i < actions.size(); ++i) {
    const float drawn =
        uniform(draw({1}, kNobody, Draw::situation, number * 100'000 + static_cast<std::uint32_t>(i))[0]);
    actions[i] = kind == Kind::menu ? std::floor(drawn * static_cast<float>(rules)) : 2 * drawn - 1;
  }
}

void play(Environment& games, int steps, Kind kind = Kind::menu, int rules = 12) {
  for (int i = 0; i < steps; ++i) {
    act_at_random(games, static_cast<std::uint32_t>(i), kind, rules);
    const auto done = games.step();
    ASSERT_TRUE(done) << done.error();
  }
}

std::uint64_t hash_of(const std::vector<float>& numbers) {
  Hash hash;
  for (const float number : numbers) hash.add(std::bit_cast<std::uint32_t>(number));
  return hash.value();
}

TEST(Environment, HasRowsByGameAndAgent) {
  const Games games = opened(R"({"games": 3, "control": "both"})");
  EXPECT_EQ(games->agents(), 8);
  EXPECT_EQ(games->arrays().observations.size(), 3u * 8 * static_cast<std::size_t>(games->columns()));
  EXPECT_EQ(games->arrays().actions.size(), 3u * 8);
  EXPECT_EQ(games->arrays().succeeded.size(), 3u);
  const io::Json about = io::Json::parse(games->about());
  EXPECT_EQ(about["agents"],
            io::Json({"home_1", "home_2", "home_3", "home_4", "away_1", "away_2", "away_3", "away_4"}));
  EXPECT_EQ(about["columns"].size(), static_cast<std::size_t>(games->columns()));
  EXPECT_EQ(about["actions"].size(), 12u);
}

TEST(Environment, AgentsAreTheControlledRobotsOfTheDrill) {
  const Games games = opened(R"({"drill": "two_against_one"})");
  EXPECT_EQ(io::Json::parse(games->about())["agents"], io::Json({"home_2", "home_3"}));
  EXPECT_EQ(Environment::open(R"({"drill": "empty_goal", "control": "away"})").error(),
            "environment: no robot of the controlled side takes part in this drill");
}

TEST(Environment, TheSameSeedsAndActionsGiveTheSameBytesOnAllBuilds) {
  Hash all;
  for (const std::string kind : {"menu", "skills", "motion"}) {
    const Games games =
        opened(R"({"games": 4, "control": "both", "drill": "kick_off", "seconds": 8, "actions": ")" + kind + "\"}");
    games->reset(seeds_from(11, 4));
    if (kind == "skills") {
      // a skill after the other, with its own arguments
      for (int i = 0; i < 120; ++i) {
        std::ranges::fill(games->arrays().actions, std::numeric_limits<float>::quiet_NaN());
        for (std::size_t row = 0; row < games->arrays().rewards.size(); ++row)
          games->arrays().actions[row * static_cast<std::size_t>(games->width())] =
              static_cast<float>((static_cast<std::size_t>(i) / 10 + row) % 13);
        ASSERT_TRUE(games->step());
        all.add(hash_of(games->arrays().observations));
      }
    } else {
      for (int i = 0; i < 120; ++i) {
        play(*games, 1, kind == "menu" ? Kind::menu : Kind::motion);
        all.add(hash_of(games->arrays().observations)), all.add(hash_of(games->arrays().rewards));
      }
    }
    for (int game = 0; game < 4; ++game) all.add(sim::hash_of(games->state(game)));
  }
  EXPECT_EQ(hex(all.value()), "72fb507bb8ee7b8c");
}

TEST(Environment, AGameDoesNotDependOnTheGamesBesideIt) {
  const std::string options = R"("drill": "two_against_one", "actions": "motion")";
  const Games many = opened("{\"games\": 21, " + options + "}"), one = opened("{\"games\": 1, " + options + "}");
  many->reset(seeds_from(40, 21)), one->reset(seeds_from(57, 1));
  for (std::uint32_t i = 0; i < 150; ++i) {
    act_at_random(*many, i, Kind::motion, 0);
    const auto wide = static_cast<std::size_t>(2 * many->width());
    std::copy_n(many->arrays().actions.data() + 17 * wide, wide, one->arrays().actions.data());
    ASSERT_TRUE(many->step() && one->step());
    ASSERT_EQ(sim::hash_of(many->state(17)), sim::hash_of(one->state(0))) << i;
    const auto row = static_cast<std::size_t>(2 * many->columns());
    ASSERT_TRUE(std::equal(one->arrays().observations.begin(), one->arrays().observations.end(),
                           many->arrays().observations.begin() + static_cast<std::ptrdiff_t>(17 * row)));
  }
}

TEST(Environment, ThreeStepsOfATickAreOneOfThreeTicks) {
  const std::string options = R"("drill": "kick_off", "games": 2, "actions": "motion")";
  const Games short_steps = opened("{\"ticks\": 1, " + options + "}"),
              long_steps = opened("{\"ticks\": 3, " + options + "}");
  for (std::uint32_t i = 0; i < 100; ++i) {
    act_at_random(*long_steps, i, Kind::motion, 0);
    float reward = 0;
    for (int tick = 0; tick < 3; ++tick) {
      short_steps->arrays().actions = long_steps->arrays().actions;
      ASSERT_TRUE(short_steps->step());
      reward += short_steps->arrays().rewards[0];
    }
    ASSERT_TRUE(long_steps->step());
    ASSERT_EQ(sim::hash_of(short_steps->state(1)), sim::hash_of(long_steps->state(1)));
    ASSERT_EQ(short_steps->arrays().observations, long_steps->arrays().observations);
    ASSERT_EQ(reward, long_steps->arrays().rewards[0]);
  }
}

TEST(Environment, AnObservationIsThatOfTheRobotsNewestTurn) {
  const Games games =
      opened(R"({"games": 2, "drill": "kick_off", "ticks": 1, "control": "both", "actions": "motion"})");
  games->reset(seeds_from(1, 2));
  const auto columns = static_cast<std::size_t>(games->columns());
  std::vector<float> before = games->arrays().observations;
  int changes = 0, turns = 0;
  for (int i = 0; i < 300; ++i) {
    const Tick now = games->state(1).world.tick;
    bool has_turn[8];
    for (int agent = 0; agent < 8; ++agent) {
      const int robot = robot_of(agent < 4 ? Side::home : Side::away, agent % 4 + 1);
      has_turn[agent] = games->state(1).schedule.turn[robot] <= now;
    }
    play(*games, 1, Kind::motion);
    const std::vector<float>& after = games->arrays().observations;
    for (std::size_t agent = 0; agent < 8; ++agent) {
      const auto row = static_cast<std::ptrdiff_t>((8 + agent) * columns);
      const bool changed =
          !std::equal(before.begin() + row, before.begin() + row + games->columns(), after.begin() + row);
      ASSERT_TRUE(has_turn[agent] || !changed);
      changes += changed, turns += has_turn[agent];
    }
    before = after;
  }
  EXPECT_GT(changes, 100);
  EXPECT_GE(turns, changes);
}

TEST(Environment, AnEndedGameBeginsAnewInTheNextStepWithoutReward) {
  const Games games = opened(R"({"drill": "empty_goal", "seconds": 2, "games": 2, "ticks": 30})");
  games->reset(seeds_from(5, 2));
  Arrays& arrays = games->arrays();
  play(*games, 2);
  EXPECT_EQ(arrays.truncated, (std::vector<std::uint8_t>{1, 1}));
  EXPECT_EQ(arrays.terminated, (std::vector<std::uint8_t>{0, 0}));
  EXPECT_EQ(arrays.active, (std::vector<std::uint8_t>{0, 0}));
  EXPECT_EQ(arrays.seeds[0], 5u);
  // the action of this step has no effect, whatever it is
  arrays.actions[0] = 999;
  ASSERT_TRUE(games->step());
  EXPECT_EQ(arrays.truncated, (std::vector<std::uint8_t>{0, 0}));
  EXPECT_EQ(arrays.active, (std::vector<std::uint8_t>{1, 1}));
  EXPECT_EQ(arrays.rewards, (std::vector<float>{0, 0}));
  EXPECT_NE(arrays.seeds[0], 5u);
  EXPECT_NE(arrays.seeds[0], arrays.seeds[1]);
  // the new episode is the one of its seed
  const Games same = opened(R"({"drill": "empty_goal", "seconds": 2, "games": 1, "ticks": 30})");
  same->reset(std::span(arrays.seeds).first(1));
  EXPECT_EQ(sim::hash_of(same->state(0)), sim::hash_of(games->state(0)));
}

TEST(Environment, WithRestartNeverAGameStaysAtItsEnd) {
  const Games games = opened(R"({"drill": "empty_goal", "seconds": 2, "ticks": 60, "restart": "never"})");
  play(*games, 1);
  EXPECT_EQ(games->arrays().truncated[0], 1);
  const std::uint64_t end = sim::hash_of(games->state(0));
  play(*games, 3);
  EXPECT_EQ(sim::hash_of(games->state(0)), end);
  EXPECT_EQ(games->arrays().truncated[0], 1);
  games->reset(seeds_from(1, 1));
  EXPECT_EQ(games->arrays().truncated[0], 0);
}

TEST(Environment, AResetOfSomeGamesLeavesTheOthers) {
  const Games games = opened(R"({"drill": "empty_goal", "games": 3})");
  games->reset(seeds_from(1, 3));
  play(*games, 20);
  const std::uint64_t first = sim::hash_of(games->state(0)), second = sim::hash_of(games->state(1));
  const std::uint8_t which[] = {0, 1, 0};
  games->reset(seeds_from(1, 3), which);
  EXPECT_EQ(sim::hash_of(games->state(0)), first);
  EXPECT_NE(sim::hash_of(games->state(1)), second);
  EXPECT_EQ(games->state(1).world.key.seed, 2u);
}

TEST(Environment, RewardsAreThePointsOfTheDrillAndTheAwaySideHasTheNegativeOnes) {
  const Games games = opened(R"({"drill": "empty_goal", "frame":
    {"name": "x", "based_on": "baseline", "menu": [{"use": "chaser"}]}, "games": 40, "restart": "never", "ticks": 600})");
  games->reset(seeds_from(1, 40));
  ASSERT_TRUE(games->step());
  int successes = 0;
  for (std::size_t game = 0; game < 40; ++game) {
    successes += games->arrays().succeeded[game];
    EXPECT_EQ(games->arrays().rewards[game] > 0.9f, games->arrays().succeeded[game] == 1) << game;
  }
  EXPECT_GT(successes, 10);
  EXPECT_LT(successes, 40);

  const Games both = opened(R"({"games": 20, "control": "both", "ticks": 3000, "actions": "menu"})");
  float ours = 0;
  for (int i = 0; i < 8; ++i) {
    play(*both, 1, Kind::menu, 1);
    for (std::size_t game = 0; game < 20; ++game) {
      const float* row = both->arrays().rewards.data() + 8 * game;
      EXPECT_EQ(row[0], -row[4]);
      EXPECT_EQ(row[0], row[3]);
      const std::uint8_t* score = both->state(static_cast<int>(game)).book.score;
      ours += std::abs(row[0]);
      if (i == 0) {
        EXPECT_EQ(row[0], static_cast<float>(score[0]) - static_cast<float>(score[1]));
      }
    }
  }
  EXPECT_GT(ours, 0) << "somebody scored";
}

TEST(Environment, AWholeGameEndsByItsRules) {
  const Games games = opened(R"({"rules": "spl2012,half_duration=30", "ticks": 3000, "restart": "never"})");
  for (int i = 0; i < 10 && !games->arrays().terminated[0]; ++i) play(*games, 1);
  EXPECT_EQ(games->arrays().terminated[0], 1);
  EXPECT_EQ(games->arrays().truncated[0], 0);
}

TEST(Environment, AnInvalidActionIsASentenceAndPlaysNothing) {
  const Games games = opened(R"({"games": 3})");
  games->arrays().actions[4 * 2 + 1] = 12;
  const std::uint64_t before = sim::hash_of(games->state(0));
  EXPECT_EQ(games->step().error(),
            "environment: the action of home_2 in game 2 must be a whole number 0 .. 11, got 12");
  EXPECT_EQ(sim::hash_of(games->state(0)), before);
}

TEST(Environment, AStepAllocatesNothingWhileGamesGoOn) {
  const Games games = opened(R"({"games": 8, "control": "both"})");
  play(*games, 5);
  const std::size_t before = test::allocations();
  for (int i = 0; i < 50; ++i) (void)games->step();
  EXPECT_EQ(test::allocations(), before);
}

/// Random actions of each kind, under different rules: all states stay valid, all observations in their range.
TEST(Environment, ARandomPolicyNeverLeavesTheValidStates) {
  for (const std::string rules : {"spl2012", "spl2025:7", "hsl2026"})
    for (const Kind kind : {Kind::menu, Kind::motion}) {
      const Games games = opened(R"({"games": 6, "control": "both", "rules": ")" + rules + R"(", "actions": ")" +
                                 kKinds[static_cast<int>(kind)] + "\"}");
      games->reset(seeds_from(3, 6));
      for (int i = 0; i < 30; ++i) {
        play(*games, 40, kind);
        const auto valid = games->check();
        ASSERT_TRUE(valid) << valid.error();
        for (const float value : games->arrays().observations) ASSERT_TRUE(value >= -1 && value <= 1);
      }
    }
}

}  // namespace
}  // namespace sim::environment
