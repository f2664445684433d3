#include "sim/debug/timeline.h"

#include <gtest/gtest.h>

#include <random>

#include "sim/match/fields.h"
#include "sim/match/hash.h"
#include "tests/sim/debug/played.h"

namespace sim::debug {
namespace {

using test::setup_of;
using test::timeline_of;

/// Returns the hash of each state of a game, in the order of ticks.
std::vector<std::uint64_t> first_run(const SharedSetup& setup, std::uint64_t seed) {
  State state = sim::test::begun(setup->params, seed);
  referee::Events events;
  std::vector<std::uint64_t> hashes{hash_of(state)};
  while (!finished(state)) {
    step(setup->params, state, events);
    hashes.push_back(hash_of(state));
  }
  return hashes;
}

TEST(Timeline, AGamePlayedOnFromAnyKeyFrameEqualsTheFirstRunToTheBit) {
  for (const std::uint64_t seed : {1u, 2u, 3u}) {
    const SharedSetup setup = setup_of("baseline", seed == 2 ? "passing" : "kick_now", 90);
    const std::vector<std::uint64_t> expected = first_run(setup, seed);
    Timeline timeline = timeline_of(setup, seed);
    timeline.at(kNever);
    ASSERT_EQ(timeline.played() + 1, expected.size());

    // from each key frame to the next one: so every run from a key frame to the end is covered
    std::vector<Tick> frames = timeline.key_frames();
    frames.push_back(timeline.played());
    for (std::size_t i = 0; i + 1 < frames.size(); ++i) {
      EXPECT_EQ(hash_of(timeline.at(frames[i])), expected[frames[i]]);
      timeline.replay(frames[i], frames[i + 1], [&](const State&, const State& after, const referee::Events&) {
        EXPECT_EQ(hash_of(after), expected[after.world.tick]) << "seed " << seed << ", tick " << after.world.tick;
        return !testing::Test::HasFailure();
      });
    }
  }
}

TEST(Timeline, AReplayTakesTheEditsOnItsWay) {
  const SharedSetup setup = setup_of("baseline", "baseline", 60);
  Timeline timeline = timeline_of(setup, 7);
  State state = timeline.at(700);
  state.world.ball.position = {1, 0.5f};
  timeline.change(state, setup);
  const std::uint64_t later = hash_of(timeline.at(800));
  const State last = timeline.replay(650, 800, [](const State&, const State&, const referee::Events&) { return true; });
  EXPECT_EQ(hash_of(last), later);
}

TEST(Timeline, AnyTickIsReachedInAnyOrder) {
  const SharedSetup setup = setup_of("baseline", "baseline", 60);
  const std::vector<std::uint64_t> expected = first_run(setup, 7);
  std::mt19937 random(1);
  Timeline timeline = timeline_of(setup, 7);
  for (int n = 0; n < 300; ++n) {
    const auto tick = static_cast<Tick>(random() % expected.size());
    EXPECT_EQ(hash_of(timeline.at(tick)), expected[tick]) << tick;
  }
  EXPECT_EQ(hash_of(timeline.at(kNever)), expected.back()) << "behind the end there is the last state";
}

TEST(Timeline, KeyFramesOfA20MinuteGameNeedAtMost16MBAndLieCloselyTogether) {
  Timeline timeline = timeline_of(setup_of("baseline", "baseline", 600), 7);
  timeline.at(kNever);
  EXPECT_GT(timeline.played(), ticks(1200));
  EXPECT_LE(timeline.bytes(), Timeline::kMostBytes);
  EXPECT_LE(timeline.interval(), 32u) << "about a second is played again at most";
  const std::vector<Tick> frames = timeline.key_frames();
  for (std::size_t i = 1; i < frames.size(); ++i) EXPECT_EQ(frames[i] - frames[i - 1], timeline.interval());
}

TEST(Timeline, LessMemoryMakesFewerKeyFramesOfTheSameGame) {
  const SharedSetup setup = setup_of("baseline", "baseline", 60);
  const std::vector<std::uint64_t> expected = first_run(setup, 3);
  Timeline timeline(setup, sim::test::begun(setup->params, 3), 10 * sizeof(State));
  timeline.at(kNever);
  EXPECT_LE(timeline.bytes(), 10 * sizeof(State));
  for (Tick tick = 0; tick < expected.size(); tick += 97) EXPECT_EQ(hash_of(timeline.at(tick)), expected[tick]);
}

TEST(Timeline, AChangeBeginsAnotherFutureAndKeepsThePast) {
  const SharedSetup setup = setup_of("baseline", "baseline", 60);
  const std::vector<std::uint64_t> expected = first_run(setup, 5);
  Timeline timeline = timeline_of(setup, 5);
  timeline.at(2000);
  const Timeline before = timeline;
  State changed = timeline.at(1003);
  place(changed.world.ball, {1.5f, 0.3f});
  timeline.change(changed, setup);
  EXPECT_EQ(difference(timeline.at(1003), changed), "");
  EXPECT_EQ(hash_of(timeline.at(1002)), expected[1002]);
  EXPECT_NE(hash_of(timeline.at(1500)), expected[1500]);
  Timeline copy = before;
  EXPECT_EQ(hash_of(copy.at(1500)), expected[1500]) << "a copy keeps its own future";

  // the changed future is one game, too
  State state = changed;
  referee::Events events;
  while (state.world.tick < 1500) step(setup->params, state, events);
  EXPECT_EQ(difference(timeline.at(1500), state), "");
}

TEST(Timeline, AChangeWithoutADifferenceHasTheSameFuture) {
  const SharedSetup setup = setup_of("baseline", "baseline", 60);
  const std::vector<std::uint64_t> expected = first_run(setup, 5);
  Timeline timeline = timeline_of(setup, 5);
  timeline.change(timeline.at(1003), setup);
  for (const Tick tick : {1002u, 1003u, 1200u, 3000u}) EXPECT_EQ(hash_of(timeline.at(tick)), expected[tick]);
}

TEST(Timeline, AnotherSetupIsPlayedFromItsTickOnAndTheOldOneBefore) {
  const SharedSetup setup = setup_of("baseline", "baseline", 60), idle = setup_of("idle", "idle", 60);
  const std::vector<std::uint64_t> expected = first_run(setup, 5);
  Timeline timeline = timeline_of(setup, 5);
  timeline.change(timeline.at(2000), idle);
  EXPECT_EQ(timeline.setup_at(1999), setup);
  EXPECT_EQ(timeline.setup_at(2000), idle);
  timeline.at(2600);
  EXPECT_EQ(hash_of(timeline.at(1990)), expected[1990]);
  EXPECT_EQ(hash_of(timeline.at(2000)), expected[2000]);
  EXPECT_NE(hash_of(timeline.at(2600)), expected[2600]);
}

}  // namespace
}  // namespace sim::debug
