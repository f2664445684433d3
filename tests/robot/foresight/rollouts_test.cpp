#include "robot/foresight/rollouts.h"

#include <gtest/gtest.h>
#include <sched.h>

#include <filesystem>
#include <fstream>
#include <string>

#include "robot/core/clock.h"
#include "sim/foresight/situation.h"
#include "sim/io/playbook.h"
#include "sim/match/play.h"
#include "tests/support/eventually.h"

namespace robot::foreseeing {
namespace {

constexpr std::uint64_t kMinute = 60'000'000'000;

Futures futures(int strategies = 1) {
  static const auto playbook = std::make_shared<const sim::io::Playbook>(
      *sim::io::prepare_playbook({.strategies = {"baseline", "kick_now"}, .rules = "spl2012"}));
  static const sim::State state = [] {
    sim::referee::Events events;
    sim::State begun = sim::begin(playbook->params.front(), {.seed = 1}, events);
    sim::play(
        playbook->params.front(), begun, [](const sim::State& now) { return now.world.tick > 3000; },
        [](const sim::referee::Event&) {});
    return begun;
  }();
  Futures futures{.playbook = playbook,
                  .strategies = {},
                  .situation = {state, {}},
                  .question = {.until = sim::foresight::Until::horizon, .horizon = sim::ticks(5)},
                  .key = {.seed = 7}};
  for (int i = 0; i < strategies; ++i) futures.strategies.push_back(i);
  return futures;
}

Progress when_there_is_some(Rollouts& rollouts) {
  Progress progress = rollouts.progress();
  EXPECT_TRUE(tests::eventually([&] { return (progress = rollouts.progress()).statistics.stripes > 0; }));
  return progress;
}

/// The scheduling policy of the thread `name`; -1: there is no such thread.
int scheduling_of(const std::string& name) {
  for (const auto& task : std::filesystem::directory_iterator("/proc/self/task")) {
    std::string called;
    std::getline(std::ifstream(task.path() / "comm"), called);
    if (called == name) return sched_getscheduler(std::stoi(task.path().filename()));
  }
  return -1;
}

TEST(Rollouts, BesideARobotUseIdleTimeOnly) {
  Rollouts rollouts(Share::left_over);
  ASSERT_TRUE(rollouts.start());
  EXPECT_TRUE(tests::eventually_equal([] { return scheduling_of("foresee"); }, SCHED_IDLE));
}

TEST(Rollouts, PlayStripesUntilTheyAreEnded) {
  Rollouts rollouts(Share::background);
  ASSERT_TRUE(rollouts.start());
  rollouts.begin(futures(2), monotonic_ns() + kMinute);
  const Progress progress = when_there_is_some(rollouts);
  EXPECT_EQ(progress.statistics.strategies, 2);
  EXPECT_EQ(progress.statistics.by_strategy[0].rollouts, progress.statistics.stripes);
  EXPECT_GT(progress.computed_ns, 0u);
  rollouts.end();
  EXPECT_GE(rollouts.progress().statistics.stripes, progress.statistics.stripes);
}

TEST(Rollouts, OfAnotherQuestionDoNotCount) {
  Rollouts rollouts(Share::background);
  ASSERT_TRUE(rollouts.start());
  rollouts.begin(futures(2), monotonic_ns() + kMinute);
  const std::uint64_t before = when_there_is_some(rollouts).race;
  rollouts.begin(futures(1), monotonic_ns() + kMinute);
  for (int i = 0; i < 1000; ++i) {
    const Progress progress = rollouts.progress();
    EXPECT_NE(progress.race, before);
    EXPECT_EQ(progress.statistics.strategies, 1);
  }
  EXPECT_EQ(when_there_is_some(rollouts).statistics.strategies, 1);
}

/// The thread may have taken any of these questions, or none.
TEST(Rollouts, AnyNumberOfQuestionsBeginAndEndWithoutWaiting) {
  Rollouts rollouts(Share::background);
  ASSERT_TRUE(rollouts.start());
  for (int i = 0; i < 300; ++i) {
    rollouts.begin(futures(), monotonic_ns() + kMinute);
    if (i % 3 == 0) rollouts.end();
  }
  EXPECT_EQ(rollouts.progress().statistics.strategies, 1);
}

TEST(Rollouts, EndWithoutEverHavingBegun) {
  Rollouts rollouts(Share::background);
  ASSERT_TRUE(rollouts.start());
  rollouts.end();
  EXPECT_EQ(rollouts.progress().statistics.stripes, 0);
}

}  // namespace
}  // namespace robot::foreseeing
