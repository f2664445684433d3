#include "sim/foresight/chooser.h"

#include <gtest/gtest.h>

#include <fstream>

#include "sim/io/chooser.h"
#include "sim/match/hash.h"
#include "sim/match/snapshot.h"
#include "tests/sim/support/games.h"
#include "tests/support/temporary_folder.h"

namespace sim::foresight {
namespace {

using agent::kNoStrategy;

/// Files of strategies for one test.
struct Files {
  tests::TemporaryFolder folder;

  std::string write(const std::string& name, const std::string& json) const {
    const std::string path = (folder / name).string();
    std::ofstream(path) << json;
    return path;
  }
  std::string sentence(const std::string& json) const {
    const auto loaded = io::load_behaviour(write("bad.json", json), {}, Side::home);
    return loaded ? "" : loaded.error();
  }
};

constexpr const char* kSleepy = R"({"name": "sleepy", "choose": ["idle", "baseline"], "opponent": "idle",
                                    "rollouts": 32, "horizon": {"value": 30, "unit": "s"}})";

io::PreparedGame game_of(const std::string& home, const std::string& models, float half) {
  io::Matchup choice = test::choice_of("spl2012", "idle", models);
  choice.strategies[0] = home;
  return test::setup_of(choice, half);
}

TEST(Chooser, WakesUpATeamThatStandsIdle) {
  const Files files;
  const io::PreparedGame setup = game_of(files.write("sleepy.json", kSleepy), "match", 120);
  State state = test::begun(setup.params, 3);
  const auto all_play = [&](int strategy) {
    for (int player = 2; player <= 4; ++player)
      if (state.robots[robot_of(Side::home, player)].mind.choice.played() != strategy) return false;
    return true;
  };
  while (!all_play(1) && state.world.tick < ticks(60)) state = test::after(setup.params, state, 1);
  EXPECT_TRUE(all_play(1)) << "it wins the ball and more than idling";
  state = test::after(setup.params, state, ticks(100));
  EXPECT_GT(state.counts.kicks[0], 0);
  EXPECT_EQ(state.robots[robot_of(Side::away, 2)].mind.choice.strategy, kNoStrategy) << "the others choose nothing";
}

/// No strategy gains anything in 1 s that a few rollouts could prove. In this game all robots are on the field then: a
/// penalised one keeps its choice.
TEST(Chooser, ReturnsToTheDefaultWhenNoneIsBetterWithCertainty) {
  const io::PreparedGame setup = game_of("foresight,rollouts=64,horizon=1", "match", 120);
  State state = test::after(setup.params, test::begun(setup.params, 4), ticks(60));
  for (int player = 2; player <= 4; ++player) choose(2, state.robots[robot_of(Side::home, player)].mind.choice);
  state = test::after(setup.params, state, ticks(15));
  for (int player = 2; player <= 4; ++player)
    EXPECT_EQ(state.robots[robot_of(Side::home, player)].mind.choice.played(), 0) << "player " << player;
}

TEST(Chooser, OnlyTheCaptainAsksWhenMessagesArrive) {
  const Files files;
  const io::PreparedGame setup = game_of(files.write("sleepy.json", kSleepy), "perfect", 60);
  State state = test::begun(setup.params, 3);
  while (state.robots[1].mind.choice.played() == 0) state = test::after(setup.params, state, 1);
  EXPECT_EQ(state.robots[1].mind.told, static_cast<std::uint16_t>(state.world.tick - 1)) << "just now";
  state = test::after(setup.params, state, 2);
  for (int robot = 0; robot < 4; ++robot) {
    EXPECT_EQ(state.robots[robot].mind.choice.played(), 1) << "robot " << robot;
    EXPECT_EQ(state.robots[robot].mind.choice.epoch, state.robots[1].mind.choice.epoch) << "robot " << robot;
  }
}

TEST(Chooser, AGameIsAFunctionOfItsSeedFromAnyMoment) {
  io::Matchup choice = test::choice_of("spl2012", "baseline", "match", Pace::thinned);
  choice.strategies[1] = "foresight,rollouts=16,horizon=5";
  const io::PreparedGame setup = test::setup_of(choice, 20);
  const State middle = test::after(setup.params, test::begun(setup.params, 9), ticks(30));
  const auto read = restore(snapshot_of(middle));
  ASSERT_TRUE(read.state) << read.refusal;
  const State end = test::after(setup.params, middle, ticks(40));
  EXPECT_EQ(hash_of(end), hash_of(test::after(setup.params, *read.state, ticks(40))));
  EXPECT_EQ(hash_of(end), hash_of(test::after(setup.params, test::begun(setup.params, 9), ticks(70))));
}

TEST(Chooser, ARobotThatHearsNobodyForLongPlaysTheDefault) {
  const auto chooser = io::load_behaviour("foresight,stale=5", {}, Side::home);
  ASSERT_TRUE(chooser) << chooser.error();
  const io::PreparedGame setup = game_of("baseline", "match", 60);
  const agent::Surroundings around{&setup.params.rules, &setup.params.teams[0].models.motion};
  agent::Game game{.phase = agent::Game::Phase::playing, .player = 1};  // the keeper never chooses
  agent::Beliefs beliefs;
  agent::Mind mind;
  beliefs.mates[1] = {.sent = 1000, .active = true, .choice = {2, 7}};
  (*chooser)->decide(around, game, beliefs, 1001, mind, nullptr);
  EXPECT_EQ(mind.choice.played(), 2);
  (*chooser)->decide(around, game, beliefs, 1000 + ticks(5) - 1, mind, nullptr);
  EXPECT_EQ(mind.choice.played(), 2);
  (*chooser)->decide(around, game, beliefs, 1000 + ticks(5), mind, nullptr);
  EXPECT_EQ(mind.choice.strategy, kNoStrategy);
  beliefs.mates[1].sent = 1200;
  (*chooser)->decide(around, game, beliefs, 1201, mind, nullptr);
  EXPECT_EQ(mind.choice.played(), 2) << "heard again";
  beliefs.mates[1].choice.strategy = 200;
  mind = {};
  (*chooser)->decide(around, game, beliefs, 1202, mind, nullptr);
  EXPECT_EQ(mind.choice.strategy, kNoStrategy) << "a strategy that this robot does not have";
}

TEST(Chooser, RefusesStrategiesThatItCannotChooseFrom) {
  const Files files;
  EXPECT_NE(files.sentence(R"({"name": "x", "choose": ["baseline"]})").find("choose must be a list of 2 .. 8"),
            std::string::npos);
  EXPECT_NE(files.sentence(R"({"name": "x", "choose": ["baseline", "tiki"]})").find("no strategy 'tiki'"),
            std::string::npos);
  EXPECT_NE(files.sentence(R"({"name": "x", "choose": ["baseline", "baseline"]})").find("occurs twice"),
            std::string::npos);
  EXPECT_NE(files.sentence(R"({"name": "x", "choose": ["baseline", "idle"], "rollout": 3})").find("rollout is unknown"),
            std::string::npos);
  EXPECT_NE(files.sentence(R"({"name": "x", "choose": ["baseline", "idle"], "opponent": "foresight"})")
                .find("no strategy 'foresight'"),
            std::string::npos)
      << "the opponents do not model our foresight";
  EXPECT_NE(files.sentence(R"({"name": 7, "choose": ["baseline", "idle"]})").find("name must be a text, got 7"),
            std::string::npos);
}

}  // namespace
}  // namespace sim::foresight
