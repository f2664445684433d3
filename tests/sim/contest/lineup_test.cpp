#include "sim/contest/lineup.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <vector>

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

TEST(Lineup, EachGameHasASeedAndACastOfItsOwn) {
  const auto lineup = Lineup::prepare({.game = {.strategies = {"baseline", "kick_now"}}, .rest = {}});
  ASSERT_TRUE(lineup) << lineup.error();
  for (const int threads : {0, 1, 3}) {
    std::vector<std::uint64_t> seeds(7);
    std::vector<const agent::Behaviour*> players(7);
    int finished = 0;
    const auto played = for_each_cast(
        *lineup, 40, 7, threads,
        [&](int game, std::uint64_t seed, const Cast& cast) {
          seeds[static_cast<std::size_t>(game)] = seed;
          players[static_cast<std::size_t>(game)] = cast.params().teams[0].behaviour;
        },
        [&](int done) { finished = done; });
    ASSERT_TRUE(played) << played.error();
    EXPECT_EQ(seeds, (std::vector<std::uint64_t>{40, 41, 42, 43, 44, 45, 46}));
    for (const agent::Behaviour* player : players) EXPECT_NE(player, lineup->params().teams[0].behaviour);
    EXPECT_LE(finished, 7);
  }
}

TEST(Lineup, ABehaviourFromOutsideThatFailsIsToldOnceAndNoOtherGameIsBegun) {
  const tests::TemporaryFolder folder;
  // it answers when it is asked who it is, and ends at once in each game
  const std::string asked = (folder.path() / "asked").string();
  const std::string program = written(folder, "once",
                                      "#!/bin/sh\n[ -e " + asked + " ] && exit 3\ntouch " + asked +
                                          "\nexec " FORESIGHT_PYTHON " " FORESIGHT_EXAMPLES "/charge.py\n");
  std::filesystem::permissions(program, std::filesystem::perms::owner_all);
  const auto lineup = Lineup::prepare({.game = {.strategies = {"pipe:" + program, "baseline"}}, .rest = {}});
  ASSERT_TRUE(lineup) << lineup.error();
  int begun = 0;
  const auto played = for_each_cast(*lineup, 1, 5, 1, [&](int, std::uint64_t seed, const Cast& cast) {
    ++begun;
    referee::Events events;
    State state = begin(cast.params(), {seed}, events);
    play_on(cast.params(), state, 60);
  });
  ASSERT_FALSE(played);
  EXPECT_NE(played.error().find("status 3"), std::string::npos) << played.error();
  EXPECT_EQ(begun, 1);
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
