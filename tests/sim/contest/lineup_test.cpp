#include "sim/contest/lineup.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <memory>
#include <mutex>
#include <set>
#include <vector>

#include "sim/contest/lineup_series.h"
#include "sim/match/hash.h"
#include "sim/match/play.h"
#include "tests/support/temporary_folder.h"

namespace sim::contest {
namespace {

std::string refusal(const std::string& strategy) {
  const auto lineup = Lineup::prepare({.game = {.strategies = {strategy, "baseline"}}, .rest = {}});
  return lineup ? "it was taken" : lineup.error();
}

/// Writes a file and returns its path.
std::string written(const tests::TemporaryFolder& folder, const std::string& name, const std::string& text) {
  const std::filesystem::path path = folder.path() / name;
  std::ofstream(path) << text;
  return path.string();
}

TEST(Lineup, AFileThatIsAProgramIsRefusedWithThePipeThatStartsIt) {
  const tests::TemporaryFolder folder;
  const std::string python = written(folder, "mine.py", "print(1)\n"), program = written(folder, "mine", "#!/bin/sh\n");
  EXPECT_EQ(refusal(python), "behaviour '" + python + "' is a program: use 'pipe:python3 " + python + "'");
  EXPECT_EQ(refusal(program), "behaviour '" + program +
                                  "' is a file, but neither JSON nor a shared library (.so) nor a program that may be "
                                  "executed");
  std::filesystem::permissions(program, std::filesystem::perms::owner_all);
  EXPECT_EQ(refusal(program), "behaviour '" + program + "' is a program: use 'pipe:" + program + "'");
}

TEST(Lineup, AFileOfJsonKeepsItsOwnError) {
  const tests::TemporaryFolder folder;
  for (const char* name : {"mine.json", "mine.txt"}) {
    const std::string tree = written(folder, name, R"({"name": "mine"})");
    EXPECT_EQ(refusal(tree), "strategy '" + tree + "': tree is missing");
  }
  const std::string broken = written(folder, "broken.json", "print(1)");
  EXPECT_EQ(refusal(broken).find("strategy '" + broken + "': not JSON: "), 0u) << refusal(broken);
}

TEST(Lineup, AStrategyThatIsNoFileKeepsItsOwnError) {
  EXPECT_EQ(refusal("basline"), "no strategy 'basline'; did you mean 'baseline'?");
  EXPECT_EQ(refusal("no/such.py").find("strategy 'no/such.py': "), 0u) << refusal("no/such.py");
}

/// A game of a series: two seconds.
struct ShortGame {
  State state;
  int decisions = 0;

  explicit ShortGame(const State& start) : state(start) {}

  bool goes_on() const { return state.world.tick < 60; }
  void see(const referee::Events& events) { decisions += events.count; }
};

/// The games of a series as they were played.
struct Played {
  std::vector<std::uint64_t> seeds, hashes;
  std::set<const Cast*> casts;
  std::vector<int> progress;
};

Played played_series(const Lineup& lineup, const Series& series) {
  Played played;
  played.seeds.resize(static_cast<std::size_t>(series.games)), played.hashes.resize(played.seeds.size());
  std::mutex lock;
  const auto result = play_series(
      lineup, series,
      [&](int number, std::uint64_t seed, const Cast& cast) {
        const std::lock_guard guard(lock);
        played.seeds[static_cast<std::size_t>(number)] = seed;
        played.casts.insert(&cast);
        referee::Events events;
        return std::make_unique<ShortGame>(begin(cast.params(), {seed}, events));
      },
      [&](int number, const ShortGame& game, const Cast& cast) {
        const std::lock_guard guard(lock);
        EXPECT_TRUE(played.casts.contains(&cast));
        EXPECT_EQ(game.state.world.tick, 60u);
        played.hashes[static_cast<std::size_t>(number)] = hash_of(game.state);
      },
      [&](int done) { played.progress.push_back(done); });
  EXPECT_TRUE(result) << result.error();
  return played;
}

TEST(LineupSeries, EachGameHasItsSeedAndTheBitsThatItHasAlone) {
  const auto lineup = Lineup::prepare({.game = {.strategies = {"baseline", "kick_now"}}, .rest = {}});
  ASSERT_TRUE(lineup) << lineup.error();
  for (const int games : {1, 7, 150}) {
    std::vector<std::uint64_t> seeds, hashes;
    for (int i = 0; i < games; ++i) {
      seeds.push_back(40 + static_cast<std::uint64_t>(i));
      referee::Events events;
      State state = begin(lineup->params(), {seeds.back()}, events);
      play_on(lineup->params(), state, 60);
      hashes.push_back(hash_of(state));
    }
    for (const int threads : {0, 1, 3}) {
      Costs costs;
      const Played played =
          played_series(*lineup, {.first_seed = 40, .games = games, .threads = threads, .costs = &costs});
      EXPECT_EQ(played.seeds, seeds);
      EXPECT_EQ(played.hashes, hashes) << games << " games on " << threads << " threads";
      EXPECT_NE(costs.text().find("a decision costs"), std::string::npos);
      for (const int done : played.progress) EXPECT_LE(done, games);
      if (threads == 1) {
        ASSERT_FALSE(played.progress.empty());
        EXPECT_EQ(played.progress.back(), games);
      }
    }
  }
}

TEST(LineupSeries, ABehaviourFromOutsidePlaysOneGameAndTreesShareTheirs) {
  io::Matchup game;
  EXPECT_GT(games_of_a_cast(*Lineup::prepare({.game = game, .rest = {}}), {.games = 200, .threads = 2}), 16);
  game.strategies[0] = FORESIGHT_CHARGE;
  const auto lineup = Lineup::prepare({.game = game, .rest = {}});
  ASSERT_TRUE(lineup) << lineup.error();
  EXPECT_EQ(games_of_a_cast(*lineup, {.games = 200, .threads = 2}), 1);
  const Played one = played_series(*lineup, {.games = 5, .threads = 1}),
               three = played_series(*lineup, {.games = 5, .threads = 3});
  EXPECT_EQ(one.hashes, three.hashes);
}

TEST(LineupSeries, NoGamesAreASeriesToo) {
  const auto lineup = Lineup::prepare({.game = {}, .rest = {}});
  ASSERT_TRUE(lineup) << lineup.error();
  EXPECT_TRUE(played_series(*lineup, {}).hashes.empty());
}

TEST(LineupSeries, ABehaviourFromOutsideThatFailsIsToldOnceAndNoOtherGameIsBegun) {
  const tests::TemporaryFolder folder;
  // it answers when it is asked who it is, and ends at once in each game
  const std::string asked = (folder.path() / "asked").string();
  const std::string program = written(folder, "once",
                                      "#!/bin/sh\n[ -e " + asked + " ] && exit 3\ntouch " + asked +
                                          "\nexec " FORESIGHT_PYTHON " " FORESIGHT_EXAMPLES "/charge.py\n");
  std::filesystem::permissions(program, std::filesystem::perms::owner_all);
  const auto lineup = Lineup::prepare({.game = {.strategies = {"pipe:" + program, "baseline"}}, .rest = {}});
  ASSERT_TRUE(lineup) << lineup.error();
  int begun = 0, ended = 0;
  const auto played = play_series(
      *lineup, {.first_seed = 1, .games = 5, .threads = 1},
      [&](int, std::uint64_t seed, const Cast& cast) {
        ++begun;
        referee::Events events;
        return std::make_unique<ShortGame>(begin(cast.params(), {seed}, events));
      },
      [&](int, const ShortGame& game, const Cast& cast) {
        ++ended;
        EXPECT_TRUE(cast.failed());
        EXPECT_LT(game.state.world.tick, 60u) << "the failure ends its game at once";
      });
  ASSERT_FALSE(played);
  EXPECT_NE(played.error().find("status 3"), std::string::npos) << played.error();
  EXPECT_EQ(begun, 1);
  EXPECT_EQ(ended, 1);
}

TEST(Lineup, TheExampleOfABehaviourFromOutsidePlaysAboutAsWellAsBaseline) {
  constexpr int kGames = 24;
  int goals[2] = {0, 0};  // of the example, of baseline
  for (const int side : {0, 1}) {
    io::Matchup game;
    game.strategies[side] = FORESIGHT_CHARGE;
    const auto lineup = Lineup::prepare({.game = game, .rest = {}});
    ASSERT_TRUE(lineup) << lineup.error();
    for (std::uint64_t seed = 1; seed <= kGames / 2; ++seed) {
      const Cast cast(*lineup, seed);
      const Result result = play_game(cast.params(), {.seed = seed});
      ASSERT_FALSE(cast.failed()) << cast.problem();
      goals[0] += result.score[side], goals[1] += result.score[1 - side];
    }
  }
  // the standard error of the difference is 0.4 goals a game
  EXPECT_NEAR(goals[0], goals[1], 1.2 * kGames);
  EXPECT_GT(goals[0], kGames / 2);
}

}  // namespace
}  // namespace sim::contest
