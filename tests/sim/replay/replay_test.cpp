#include "sim/replay/replay.h"

#include <gtest/gtest.h>

#include "sim/io/matchup.h"
#include "sim/match/hash.h"
#include "sim/match/step.h"

namespace sim::replay {
namespace {

constexpr Tick kTicks = 1800, kFrom = 600;

const Params& params(const char* home = "baseline") {
  static const io::PreparedGame plays = io::prepare({}).value();
  static const io::PreparedGame idles = io::prepare({.strategies = {"idle", "idle"}}).value();
  return std::string(home) == "idle" ? idles.params : plays.params;
}

/// A minute of a simulated game, as ground truth reports it: a robot off the field has no samples.
const Recording& recorded() {
  static const Recording made = [] {
    referee::Events events;
    State state = sim::begin(params(), {.seed = 4}, events);
    for (int i = 0; i < 2400; ++i) step(params(), state, events);
    std::vector<Sample> ball, robots[kMaxRobots];
    for (Tick tick = 0; tick < kTicks; ++tick) {
      ball.push_back({tick, state.world.ball.position, {}});
      for_each_robot(state.world.players, [&](int robot) {
        const Body& body = state.world.bodies[robot];
        if (!on_field(body)) return;
        robots[robot].push_back({tick, body.position, body.heading, lies(body)});
      });
      step(params(), state, events);
    }
    Recording recording{.ball = Track(ball), .robots = {}, .length = kTicks - 1};
    for (int robot = 0; robot < kMaxRobots; ++robot)
      recording.robots[static_cast<std::size_t>(robot)] = Track(robots[robot]);
    return recording;
  }();
  return made;
}

/// Expects that the robots of a side are where the recording has them.
void expect_as_recorded(const State& state, Side side) {
  for_each_robot(state.world.players, [&](int robot) {
    if (side_of(robot) != side) return;
    const auto place = recorded().robots[static_cast<std::size_t>(robot)].at(kFrom + state.world.tick);
    const Body& body = state.world.bodies[robot];
    ASSERT_EQ(place.has_value(), on_field(body)) << robot << " at " << state.world.tick;
    if (!place) return;
    EXPECT_EQ(body.position, place->position) << robot << " at " << state.world.tick;
    EXPECT_EQ(body.heading, place->heading) << robot << " at " << state.world.tick;
  });
}

TEST(Replay, WithBothSidesRecordedAllPositionsEqualTheRecording) {
  Replay replay(recorded(), kFrom, {true, true});
  State state = replay.begin(params("idle"), {.seed = 1});
  referee::Events events;
  for (Tick tick = 0; tick + kFrom < kTicks; ++tick) {
    expect_as_recorded(state, Side::home);
    expect_as_recorded(state, Side::away);
    EXPECT_EQ(state.world.ball.position, recorded().ball.at(kFrom + tick)->position);
    step(params("idle"), state, events);
    replay.place(params("idle"), state);
  }
}

TEST(Replay, OneSideMovesAsRecordedAndTheOtherPlaysFromItsRecordedPlaces) {
  Replay replay(recorded(), kFrom, {false, true});
  State state = replay.begin(params(), {.seed = 1});
  expect_as_recorded(state, Side::home);
  referee::Events events;
  for (Tick tick = 0; tick + kFrom + 1 < kTicks; ++tick) {
    step(params(), state, events);
    replay.place(params(), state);
    expect_as_recorded(state, Side::away);
  }
  const Tick end = kFrom + state.world.tick;
  float apart = 0;
  for (int robot = 0; robot < state.world.players; ++robot)
    if (const auto place = recorded().robots[static_cast<std::size_t>(robot)].at(end))
      apart = std::max(apart, distance(place->position, state.world.bodies[robot].position));
  EXPECT_GT(apart, 0.3f) << "the home side plays with other luck";
}

TEST(Replay, TheSameSeedIsTheSameReplayAndAnotherIsNot) {
  const auto played = [](std::uint64_t seed) {
    Replay replay(recorded(), kFrom, {false, true});
    State state = replay.begin(params(), {.seed = seed});
    referee::Events events;
    for (int i = 0; i < 600; ++i) step(params(), state, events), replay.place(params(), state);
    return hash_of_game(state);
  };
  EXPECT_EQ(played(1), played(1));
  EXPECT_NE(played(1), played(2));
}

TEST(Replay, ARobotWithoutDataStandsThenIsAbsentAndComesBack) {
  Recording recording;
  recording.ball = Track(std::vector<Sample>{{0, {0, 0}, {}}});
  std::vector<Sample> samples;
  for (Tick tick = 0; tick < 300; ++tick)
    if (tick < 50 || tick >= 200) samples.push_back({tick, {1, 1}, 0.f});
  const int robot = robot_of(Side::away, 2);
  recording.robots[static_cast<std::size_t>(robot)] = Track(samples);
  Replay replay(recording, 0, {false, true});
  State state = replay.begin(params(), {.seed = 1});
  referee::Events events;
  for (Tick tick = 0; tick < 250; ++tick) {
    const bool away = tick > 49 + kBridged && tick < 200;
    EXPECT_EQ(!on_field(state.world.bodies[robot]), away) << tick;
    step(params(), state, events);
    replay.place(params(), state);
  }
  EXPECT_EQ(replay.missing(robot).held, kBridged);
  EXPECT_EQ(replay.missing(robot).absent, 150 - kBridged);
  EXPECT_EQ(replay.missing(robot_of(Side::away, 3)).absent, 0u) << "it is not in the recording";
}

}  // namespace
}  // namespace sim::replay
