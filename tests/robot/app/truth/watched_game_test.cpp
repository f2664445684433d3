#include "robot/app/truth/watched_game.h"

#include <gtest/gtest.h>

#include <vector>

namespace robot::app {
namespace {

constexpr std::uint64_t kBeginNs = 1'700'000'000'000'000'000;

std::unique_ptr<WatchedGame> game_of(std::uint64_t seed) {
  auto game = WatchedGame::open({.matchup = {.rules = "spl2025:3"}, .seed = seed, .begin_ns = kBeginNs});
  EXPECT_TRUE(game) << game.error();
  return std::move(*game);
}

std::uint64_t seconds_in(double seconds) { return kBeginNs + static_cast<std::uint64_t>(seconds * 1e9); }

TEST(WatchedGame, ShowsTheTickBeforeATime) {
  const auto game = game_of(1);
  EXPECT_EQ(game->at(kBeginNs).tick, 0u);
  EXPECT_EQ(game->at(kBeginNs + 33'333'332).tick, 0u);
  EXPECT_EQ(game->at(kBeginNs + 33'333'333).tick, 1u);
  EXPECT_EQ(game->at(seconds_in(1)).tick, 30u);
}

TEST(WatchedGame, TwoSensorsThatLookAtDifferentTimesSeeOneGame) {
  const auto ahead = game_of(3), both = game_of(3);
  std::vector<sim::Vec2> first, second;
  for (int i = 1; i < 90; ++i) first.push_back(ahead->at(seconds_in(i / 30.0)).ball.position);
  for (int i = 1; i < 90; ++i) {
    both->at(seconds_in(i / 30.0 + 0.5));  // the other sensor is half a second ahead
    second.push_back(both->at(seconds_in(i / 30.0)).ball.position);
  }
  for (std::size_t i = 0; i < first.size(); ++i) {
    EXPECT_EQ(first[i].x, second[i].x);
    EXPECT_EQ(first[i].y, second[i].y);
  }
}

TEST(WatchedGame, AnOlderTimeThanTheKeptOnesGetsTheOldestKeptWorld) {
  const auto game = game_of(1);
  game->at(seconds_in(10));
  EXPECT_EQ(game->at(kBeginNs).tick, 300u - WatchedGame::kKept + 1);
}

TEST(WatchedGame, TellsEachTickOnceAndInOrder) {
  std::vector<std::uint64_t> told;
  const auto game = game_of(1);
  game->tell_ticks([&](const sim::World&, std::uint64_t capture_ns) { told.push_back(capture_ns); });
  game->at(seconds_in(2));
  game->at(seconds_in(1));
  game->at(seconds_in(3));
  ASSERT_EQ(told.size(), 91u);
  for (std::size_t i = 0; i < told.size(); ++i) EXPECT_EQ(told[i], kBeginNs + i * 100'000'000 / 3);
}

TEST(WatchedGame, AnotherGameFollowsTheEndOfAGame) {
  const auto game = game_of(1);
  const std::uint64_t seed = game->at(kBeginNs).key.seed;
  sim::World world = game->at(kBeginNs);
  for (int minute = 1; minute < 60 && world.key.seed == seed; ++minute) world = game->at(seconds_in(60 * minute));
  EXPECT_EQ(world.key.seed, seed + 1);
}

TEST(WatchedGame, RefusesUnknownNames) {
  const auto game = WatchedGame::open({.matchup = {.rules = "spl1812"}});
  ASSERT_FALSE(game);
  EXPECT_NE(game.error().find("spl1812"), std::string::npos);
}

}  // namespace
}  // namespace robot::app
