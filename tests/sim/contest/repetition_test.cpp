#include "sim/contest/repetition.h"

#include <gtest/gtest.h>

#include "sim/io/matchup.h"
#include "sim/match/hash.h"
#include "sim/match/play.h"

namespace sim::contest {
namespace {

std::int64_t different_of(const char* models) {
  io::PreparedGame game = io::prepare({.models = {models, models}}).value();
  game.params.rules.half_duration = 20;
  std::vector<std::uint64_t> hashes;
  for (std::uint64_t seed = 1; seed <= 6; ++seed) {
    referee::Events opening;
    State state = begin(game.params, {.seed = seed}, opening);
    play_on(game.params, state);
    hashes.push_back(hash_of_game(state));
  }
  return different_games(hashes);
}

TEST(Repetition, CountsEachHashOnce) {
  EXPECT_EQ(different_games({}), 0);
  EXPECT_EQ(different_games({7, 3, 7, 7, 3}), 2);
  EXPECT_EQ(different_games({1, 2, 3}), 3);
}

TEST(Repetition, PerfectModelsRepeatGamesAndNoiseDoesNot) {
  // the seed still tosses the coin for the kick-off
  EXPECT_EQ(different_of("perfect"), 2);
  EXPECT_EQ(different_of("match"), 6);
}

}  // namespace
}  // namespace sim::contest
