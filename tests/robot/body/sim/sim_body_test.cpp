#include "robot/body/sim/sim_body.h"

#include <gtest/gtest.h>

#include <chrono>
#include <map>
#include <set>
#include <thread>

#include "robot/bridge/to_messages.h"
#include "robot/memory/channels.h"
#include "sim/agent/follower.h"
#include "sim/io/strategy.h"
#include "sim/match/situation.h"
#include "sim/match/step.h"
#include "tests/robot/body/sim/support.h"
#include "tests/support/eventually.h"

namespace robot::body {
namespace {

using tests::kShortRules;
using tests::Recording;
using tests::setup;

const SessionClock kClock;

std::unique_ptr<SimBody> body(SimOptions options = {}, GameSetup with = setup()) {
  auto opened = SimBody::open(std::move(with), options, kClock);
  EXPECT_TRUE(opened) << (opened ? "" : opened.error());
  return std::move(*opened);
}

std::string truth_of(const sim::State& state) {
  foresight::GroundTruth truth;
  bridge::to_proto(state.world, {}, truth);
  return truth.SerializeAsString();
}

/// The truth after each of `ticks` ticks of the game of `seed`, as the simulator alone plays it; first the beginning.
std::vector<std::string> played_by_the_simulator(std::uint64_t seed, int ticks) {
  const GameSetup with = setup();
  sim::referee::Events events;
  sim::State state = sim::begin(with.params(), {seed}, events);
  std::vector<std::string> truths = {truth_of(state)};
  for (int tick = 0; tick < ticks; ++tick) {
    sim::step(with.params(), state, events);
    truths.push_back(truth_of(state));
  }
  return truths;
}

std::vector<std::string> bytes_of(const Recording& recording) {
  std::vector<std::string> bytes;
  for (const Recording::Message& message : recording.messages()) bytes.push_back(message.bytes);
  return bytes;
}

TEST(SimBody, PlaysTheGameOfItsSeedTickByTick) {
  const auto player = body({.seed = 7});
  const Recording truth(player->memory()->truth);
  ASSERT_TRUE(player->step(600));
  EXPECT_EQ(bytes_of(truth), played_by_the_simulator(7, 600));
}

TEST(SimBody, SpeedChangesNothingOfTheGame) {
  const auto player = body({.seed = 7, .speed = 100});
  ASSERT_TRUE(player->start());
  ASSERT_TRUE(tests::eventually([&] { return player->state().tick() >= 900; }));
  player->pause();
  const int ticks = static_cast<int>(player->state().tick());
  EXPECT_EQ(player->memory()->truth.read()->bytes(), played_by_the_simulator(7, ticks).back());
}

TEST(SimBody, EachSteppedTickIsWrittenAndNoOther) {
  const auto player = body();
  ASSERT_TRUE(player->start());
  player->pause();
  const std::uint32_t before = player->state().tick();
  const Recording truth(player->memory()->truth), state(player->memory()->simulation);
  ASSERT_TRUE(player->step(5));
  ASSERT_TRUE(player->step(1));
  EXPECT_EQ(player->state().tick(), before + 6);
  EXPECT_EQ(truth.messages().size(), 7u);                       // the first is what there was
  std::this_thread::sleep_for(std::chrono::milliseconds(100));  // three ticks of a game that does not pause
  EXPECT_EQ(truth.messages().size(), 7u);
  EXPECT_EQ(player->state().tick(), before + 6);
}

TEST(SimBody, StepPausesAndResumeGoesOn) {
  const auto player = body();
  ASSERT_TRUE(player->start());
  EXPECT_FALSE(player->state().paused());
  ASSERT_TRUE(player->step(1));
  EXPECT_TRUE(player->state().paused());
  const std::uint32_t tick = player->state().tick();
  ASSERT_TRUE(player->resume());
  EXPECT_FALSE(player->state().paused());
  EXPECT_TRUE(tests::eventually([&] { return player->state().tick() > tick + 2; }));
}

TEST(SimBody, GoesBackAndTheSameFutureFollows) {
  const auto player = body({.seed = 7});
  const Recording truth(player->memory()->truth), decisions(player->memory()->decision);
  ASSERT_TRUE(player->step(700));
  const std::vector<std::string> first = bytes_of(truth);
  const std::string decision = decisions.messages().back().bytes;
  ASSERT_TRUE(player->back(1));
  EXPECT_EQ(player->state().tick(), 699u);
  EXPECT_TRUE(player->state().paused());
  ASSERT_TRUE(player->step(1));
  EXPECT_EQ(decisions.messages().back().bytes, decision);

  ASSERT_TRUE(player->back(450));
  EXPECT_EQ(player->state().tick(), 250u);
  EXPECT_EQ(bytes_of(truth).back(), first[first.size() - 1 - 450]);
  ASSERT_TRUE(player->step(450));
  const std::vector<std::string> again = bytes_of(truth);
  EXPECT_TRUE(std::equal(first.end() - 450, first.end(), again.end() - 450));
}

TEST(SimBody, GoesBackAtMostToTheBeginning) {
  const auto player = body({.seed = 7});
  const std::string start(player->memory()->truth.read()->bytes());
  ASSERT_TRUE(player->step(100));
  ASSERT_TRUE(player->back(SimBody::kMostBack));
  EXPECT_EQ(player->state().tick(), 0u);
  EXPECT_EQ(player->memory()->truth.read()->bytes(), start);
  ASSERT_TRUE(player->back(1));
  EXPECT_EQ(player->state().tick(), 0u);
  ASSERT_TRUE(player->step(200));
  EXPECT_EQ(player->memory()->truth.read()->bytes(), played_by_the_simulator(7, 200).back());
}

TEST(SimBody, GoesOnAfterGoingBackFromTheEnd) {
  const auto player = body({}, setup(kShortRules));
  ASSERT_TRUE(player->step(SimBody::kMostSteps));
  ASSERT_TRUE(player->state().finished());
  ASSERT_TRUE(player->back(30));
  EXPECT_FALSE(player->state().finished());
  ASSERT_TRUE(player->step(SimBody::kMostSteps));
  EXPECT_TRUE(player->state().finished());
}

TEST(SimBody, ResetBeginsTheGameOfASeedAgain) {
  const auto player = body({.seed = 7});
  ASSERT_TRUE(player->step(50));
  for (const std::uint64_t seed : {std::uint64_t{8}, std::uint64_t{7}}) {
    ASSERT_TRUE(player->reset(seed));
    EXPECT_EQ(player->state().tick(), 0u);
    EXPECT_EQ(player->state().seed(), seed);
    const Recording truth(player->memory()->truth);
    ASSERT_TRUE(player->step(300));
    EXPECT_EQ(bytes_of(truth), played_by_the_simulator(seed, 300));
  }
  EXPECT_NE(played_by_the_simulator(7, 300), played_by_the_simulator(8, 300));
}

TEST(SimBody, AGameContinuesFromASituation) {
  const auto player = body();
  sim::State state = sim::random_situation(player->setup().params(), {5});
  player->reset(state);
  EXPECT_EQ(player->memory()->truth.read()->bytes(), truth_of(state));
  ASSERT_TRUE(player->step(100));
  sim::referee::Events events;
  for (int tick = 0; tick < 100; ++tick) sim::step(player->setup().params(), state, events);
  EXPECT_EQ(player->memory()->truth.read()->bytes(), truth_of(state));
  EXPECT_EQ(player->state().seed(), 5u);
}

/// The strategy of the last decision.
std::string played_by(const memory::Channels& channels, const std::string& robot) {
  const auto version = channels.find("/" + robot + "/decision")->newest();
  foresight::DecisionTrace trace;
  if (version) trace.ParseFromString(std::string(version->bytes()));
  return trace.strategy();
}

TEST(SimBody, TheTeamPlaysTheStrategyOfItsCaptain) {
  body::GameSetup with = setup();
  std::vector<std::shared_ptr<const sim::agent::Behaviour>> strategies;
  for (const char* name : {"baseline", "kick_now"}) strategies.push_back(*sim::io::load_strategy(name));
  with.game.behaviours[0] = std::make_shared<sim::agent::Follower>("baseline", strategies, sim::ticks(20));
  with.game.params.teams[0].behaviour = with.game.behaviours[0].get();
  const auto player = body({.robot = sim::robot_of(sim::Side::home, 2), .seed = 2}, std::move(with));
  memory::Channels channels;
  ASSERT_TRUE(player->list(channels));
  const auto choose = [&](std::uint32_t number, bool chosen, std::uint32_t epoch) {
    foresight::Strategy strategy;
    strategy.set_number(number);
    strategy.set_chosen(chosen);
    strategy.set_epoch(epoch);
    player->memory()->strategy.write(strategy, kClock.now_ns());
  };
  const std::string own = "14/2", mate = "14/3", opponent = "5/2";
  ASSERT_TRUE(player->step(1500));
  EXPECT_EQ(played_by(channels, own), "baseline");
  choose(1, true, 1);
  ASSERT_TRUE(player->step(1));
  EXPECT_EQ(played_by(channels, own), "kick_now");
  EXPECT_EQ(played_by(channels, mate), "baseline") << "it has not heard of it yet";
  ASSERT_TRUE(player->step(sim::ticks(5)));
  EXPECT_EQ(played_by(channels, mate), "kick_now");
  EXPECT_EQ(played_by(channels, opponent), "baseline");
  choose(0, false, 1);
  ASSERT_TRUE(player->step(1));
  EXPECT_EQ(played_by(channels, own), "baseline");
}

TEST(SimBody, EveryRobotIsListedUnderItsName) {
  const auto player = body({.robot = sim::robot_of(sim::Side::away, 3)});
  memory::Channels channels;
  ASSERT_TRUE(player->list(channels));
  std::map<std::string, int> objects;  // by robot
  std::set<std::string> own;
  for (const auto& channel : channels.all()) {
    const std::string& topic = channel->info().topic;
    ++objects[topic.substr(0, topic.rfind('/'))];
    if (topic.starts_with("/5/3/")) own.insert(topic.substr(5));
  }
  for (const char* robot : {"/14/1", "/14/2", "/14/3", "/14/4", "/5/1", "/5/2", "/5/4"}) EXPECT_EQ(objects[robot], 11);
  EXPECT_EQ(own, (std::set<std::string>{"ball", "camera_top_matrix", "clock", "decision", "forecast", "forecast_score",
                                        "game", "log", "motion_command", "motion_status", "odometry", "opponents",
                                        "pose", "runtime", "strategy", "team", "vision", "what_if"}));
  EXPECT_TRUE(channels.find("/truth/world"));
  EXPECT_TRUE(channels.find("/sim/state"));
  EXPECT_EQ(channels.all().size(), 7u * 11 + 18 + 2);
  EXPECT_EQ(player->memory()->ball.info().topic, "/5/3/ball");
}

// without noise a robot believes what is true
TEST(SimBody, ABeliefAndItsTruthHaveEqualCaptureTimes) {
  const auto player = body({.robot = 2}, setup("spl2012", "perfect"));
  const Recording truth(player->memory()->truth), pose(player->memory()->pose), game(player->memory()->game);
  ASSERT_TRUE(player->step(400));
  std::map<std::uint64_t, foresight::GroundTruth> truths;
  for (const auto& [capture_ns, bytes] : truth.messages()) truths[capture_ns].ParseFromString(bytes);
  foresight::GameState told;
  told.ParseFromString(game.messages().front().bytes);
  const float sign = told.attacks_positive_x() ? 1.f : -1.f;
  std::size_t compared = 0;
  for (const auto& [capture_ns, bytes] : pose.messages()) {
    foresight::Pose believed;
    believed.ParseFromString(bytes);
    const auto at = truths.find(capture_ns);
    if (at == truths.end()) continue;
    for (const auto& robot : at->second.robots()) {
      if (robot.team() != 14 || robot.player() != 3) continue;
      EXPECT_NEAR(sign * believed.x(), robot.x(), 1e-4) << compared;
      EXPECT_NEAR(sign * believed.y(), robot.y(), 1e-4) << compared;
      ++compared;
    }
  }
  EXPECT_GT(compared, 200u);
}

TEST(SimBody, CaptureTimesNeverGoBack) {
  const auto player = body({.seed = 3, .speed = 50});
  memory::Channels channels;
  ASSERT_TRUE(player->list(channels));
  std::vector<std::unique_ptr<Recording>> recordings;
  for (const auto& channel : channels.all()) recordings.push_back(std::make_unique<Recording>(*channel));
  ASSERT_TRUE(player->start());
  for (const double speed : {100.0, 0.1, 30.0, 1.0}) {
    ASSERT_TRUE(tests::eventually([&] { return player->memory()->truth.read()->sequence() % 7 == 0; }));
    ASSERT_TRUE(player->set_speed(speed));
    ASSERT_TRUE(player->step(3));
    ASSERT_TRUE(player->reset(11));
    ASSERT_TRUE(player->step(40));
    ASSERT_TRUE(player->resume());
  }
  player->stop();
  const std::uint64_t now_ns = kClock.now_ns();
  for (const auto& recording : recordings) {
    std::uint64_t last_ns = 0;
    for (const auto& [capture_ns, bytes] : recording->messages()) {
      EXPECT_GE(capture_ns, last_ns);
      EXPECT_LE(capture_ns, now_ns + 1000);
      last_ns = capture_ns;
    }
  }
}

TEST(SimBody, StandsAtTheEndUntilAReset) {
  const auto player = body({.seed = 1, .speed = 100}, setup(kShortRules));
  ASSERT_TRUE(player->start());
  ASSERT_TRUE(tests::eventually([&] { return player->state().finished(); }));
  const std::uint32_t tick = player->state().tick();
  const std::string over = "simulation: the game is over; a reset begins another one";
  EXPECT_EQ(player->step(1).error(), over);
  EXPECT_EQ(player->resume().error(), over);
  EXPECT_EQ(player->state().tick(), tick);
  ASSERT_TRUE(player->reset(2));
  EXPECT_FALSE(player->state().finished());
  EXPECT_TRUE(tests::eventually([&] { return player->state().finished(); }));
}

TEST(SimBody, StepEndsWithTheGame) {
  const auto player = body({}, setup(kShortRules));
  ASSERT_TRUE(player->step(SimBody::kMostSteps));
  EXPECT_TRUE(player->state().finished());
  EXPECT_LT(player->state().tick(), SimBody::kMostSteps);
}

TEST(SimBody, ALoopPlaysTheNextSeed) {
  const auto player = body({.seed = 5, .speed = 100, .loop = true, .rest_ns = kMillisecond}, setup(kShortRules));
  ASSERT_TRUE(player->start());
  EXPECT_TRUE(tests::eventually([&] { return player->state().seed() == 7; }));
}

/// An hour's rest between two games is not waited for.
TEST(SimBody, StopDoesNotWait) {
  for (const bool paused : {false, true}) {
    const auto player = body({.speed = 100, .loop = true, .rest_ns = 3600 * kSecond}, setup(kShortRules));
    ASSERT_TRUE(player->start());
    ASSERT_TRUE(tests::eventually([&] { return player->state().finished(); }));
    if (paused) player->pause();
    player->stop();
    const std::uint64_t written = player->memory()->truth.read()->sequence();
    std::this_thread::sleep_for(std::chrono::milliseconds(20));  // many ticks of a game that does not stop
    EXPECT_EQ(player->memory()->truth.read()->sequence(), written);
  }
}

TEST(SimBody, RefusesValuesOutOfRangeWithASentence) {
  const auto player = body();
  EXPECT_EQ(player->step(0).error(), "simulation: 'ticks' must be 1 .. 1800, got 0");
  EXPECT_EQ(player->step(1801).error(), "simulation: 'ticks' must be 1 .. 1800, got 1801");
  EXPECT_EQ(player->back(0).error(), "simulation: 'ticks' must be 1 .. 1000000, got 0");
  EXPECT_FALSE(player->back(SimBody::kMostBack + 1));
  EXPECT_EQ(player->set_speed(0.05).error(), "simulation: 'speed' must be 0.1 .. 100, got 0.050000");
  EXPECT_FALSE(player->set_speed(std::numeric_limits<double>::quiet_NaN()));
  EXPECT_FALSE(player->reset(SimBody::kGreatestSeed + 1));
  const auto open = [](SimOptions options, bridge::TeamNumbers teams = {}) {
    body::GameSetup with = setup();
    with.names.teams = teams;
    return SimBody::open(std::move(with), options, kClock);
  };
  EXPECT_EQ(open({.robot = 4}).error(), "simulation: in spl2012 'player' must be 1 .. 4, got 5");
  EXPECT_EQ(open({}, {.home = 5, .away = 5}).error(), "simulation: the two teams need different numbers, both have 5");
  EXPECT_FALSE(open({.speed = 101}));
}

TEST(SimBody, OrdersComeFromAnyThread) {
  const auto player = body({.speed = 20});
  ASSERT_TRUE(player->start());
  std::vector<std::thread> people;
  for (int person = 0; person < 4; ++person)
    people.emplace_back([&, person] {
      for (int order = 0; order < 20; ++order) {
        const Result<void> done = person == 0   ? player->step(3)
                                  : person == 1 ? player->resume()
                                  : person == 2 ? player->set_speed(1 + order)
                                                : player->reset(static_cast<std::uint64_t>(order));
        EXPECT_TRUE(done);
        EXPECT_LE(player->state().seed(), 20u);
      }
    });
  for (std::thread& person : people) person.join();
  player->stop();
}

}  // namespace
}  // namespace robot::body
