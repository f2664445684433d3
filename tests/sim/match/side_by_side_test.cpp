// Games that are played side by side have the bits of games alone.
#include <gtest/gtest.h>

#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "sim/match/hash.h"
#include "sim/match/play.h"
#include "sim/math/lanes.h"
#include "tests/sim/support/games.h"

namespace sim {
namespace {

using test::choice_of;
using test::setup_of;

/// A game, its events and its hash every second.
struct Game {
  State state;
  Tick length = kNever;  // [ticks]
  std::vector<referee::Event> events{};
  std::vector<std::uint64_t> hashes{};

  bool goes_on() {
    if (state.world.tick % 30 == 0) hashes.push_back(hash_of(state));
    return state.world.tick < length;
  }
  void see(const referee::Events& decided) { events.insert(events.end(), decided.begin(), decided.end()); }
};

/// Returns `count` games of different lengths, so that places become free.
std::vector<Game> games_of(const Params& params, int count) {
  std::vector<Game> games;
  referee::Events events;
  for (int i = 0; i < count; ++i)
    games.push_back(
        {begin(params, {.seed = static_cast<std::uint64_t>(100 + i)}, events), static_cast<Tick>(120 + 37 * (i % 7))});
  return games;
}

void play_together(const Params& params, std::vector<Game>& games, std::size_t together) {
  std::size_t begun = 0;
  play_many<Game>(params, together, [&](Game*) { return begun < games.size() ? &games[begun++] : nullptr; });
}

TEST(SideBySide, ManyGamesHaveTheBitsOfGamesAlone) {
  const std::pair<const char*, const char*> kinds[] = {
      {"spl2012", "match"}, {"spl2025", "match"}, {"hsl2026", "match"}, {"spl2025", "match,falls.table=foresight"}};
  for (const auto& [rules, models] : kinds)
    for (const Pace pace : {Pace::thinned, Pace::every_tick}) {
      const auto setup = setup_of(choice_of(rules, "baseline", models, pace), 60);
      for (const int count : {1, 3, 16, 37}) {
        std::vector<Game> alone = games_of(setup.params, count), together = alone;
        for (Game& game : alone) {
          referee::Events events;
          while (!finished(game.state) && game.goes_on()) {
            step(setup.params, game.state, events);
            game.see(events);
          }
        }
        play_together(setup.params, together, count == 37 ? 8 : kTogether);
        for (std::size_t i = 0; i < alone.size(); ++i) {
          ASSERT_EQ(together[i].hashes, alone[i].hashes) << rules << ", game " << i << " of " << count;
          ASSERT_EQ(together[i].events.size(), alone[i].events.size());
        }
      }
    }
}

TEST(SideBySide, GamesAtDifferentTicksShareAPass) {
  const auto setup = setup_of(choice_of("spl2012", "baseline", "match"), 60);
  std::vector<Game> games = games_of(setup.params, 5);
  for (std::size_t i = 0; i < games.size(); ++i) play_on(setup.params, games[i].state, static_cast<Tick>(37 * i));
  std::vector<Game> alone = games;
  for (Game& game : alone) play_on(setup.params, game.state, 400);
  std::vector<State*> states;
  for (Game& game : games) states.push_back(&game.state);
  std::vector<referee::Events> events(states.size());
  for (int i = 0; i < 400; ++i) step_many(setup.params, states, events);
  for (std::size_t i = 0; i < games.size(); ++i) EXPECT_EQ(hash_of(games[i].state), hash_of(alone[i].state)) << i;
}

TEST(SideBySide, MoreGamesThanAPassTakes) {
  const auto setup = setup_of(choice_of("spl2012", "baseline", "match"), 60);
  std::vector<Game> games = games_of(setup.params, static_cast<int>(kMostGames) + 9), alone = games;
  std::vector<State*> states;
  for (Game& game : games) states.push_back(&game.state);
  std::vector<referee::Events> events(states.size());
  for (int i = 0; i < 60; ++i) step_many(setup.params, states, events);
  for (std::size_t i = 0; i < games.size(); ++i) {
    play_on(setup.params, alone[i].state, 60);
    ASSERT_EQ(hash_of(games[i].state), hash_of(alone[i].state)) << i;
  }
}

TEST(SideBySide, GamesArePlayedOnToTheirEndsOrForAWhile) {
  const auto setup = setup_of(choice_of("spl2012", "baseline", "match"), 60);
  std::vector<State> games;
  for (const Game& game : games_of(setup.params, static_cast<int>(kMostGames) + 3)) games.push_back(game.state);
  play_on(setup.params, games[1]);
  std::vector<State> alone = games;
  play_on(setup.params, games, 200);
  for (std::size_t i = 0; i < games.size(); ++i) {
    play_on(setup.params, alone[i], 200);
    ASSERT_EQ(hash_of(games[i]), hash_of(alone[i])) << i;
  }
  EXPECT_TRUE(finished(games[1]));
  EXPECT_FALSE(finished(games[0]));
}

TEST(SideBySide, NarrowAndWideLanesPlayTheSameGame) {
  const auto setup = setup_of(choice_of("spl2012", "baseline", "match"), 60);
  std::vector<Game> wide = games_of(setup.params, 9), narrow = wide;
  play_together(setup.params, wide, kTogether);
  only_narrow_lanes = true;
  play_together(setup.params, narrow, kTogether);
  only_narrow_lanes = false;
  for (std::size_t i = 0; i < wide.size(); ++i) EXPECT_EQ(narrow[i].hashes, wide[i].hashes) << i;
}

TEST(SideBySide, AGameThatIsOverLeavesItsPlaceToTheNext) {
  const auto setup = setup_of(choice_of("spl2012", "baseline", "match"), 20);
  std::vector<RandomKey> keys;
  for (std::uint64_t seed = 1; seed <= 2 * kTogether + 3; ++seed) keys.push_back({seed});
  const std::vector<Result> results = play_games(setup.params, keys);
  ASSERT_EQ(results.size(), keys.size());
  for (const std::size_t i : {std::size_t{0}, kTogether - 1, kTogether, keys.size() - 1}) {
    const Result alone = play_game(setup.params, keys[i]);
    EXPECT_TRUE(results[i].over);
    EXPECT_EQ(results[i].ticks, alone.ticks);
    EXPECT_EQ(results[i].score[0], alone.score[0]);
    EXPECT_EQ(results[i].walked[1], alone.walked[1]);
    EXPECT_EQ(results[i].packets[0], alone.packets[0]);
  }
}

TEST(SideBySide, NoGamesAreNoWork) {
  const auto setup = setup_of(choice_of("spl2012", "baseline", "match"), 20);
  EXPECT_TRUE(play_games(setup.params, {}).empty());
  step_many(setup.params, {}, {});
}

}  // namespace
}  // namespace sim
