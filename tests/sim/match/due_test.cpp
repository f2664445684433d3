#include "sim/match/due.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <random>

#include "sim/match/pace.h"
#include "sim/math/lanes.h"

namespace sim {
namespace {

/// A time before, at or after `now`, or a special one.
Tick wild_tick(std::mt19937& random, Tick now) {
  const std::array special{Tick{0}, kNever, now, now - 1, now + 1, static_cast<Tick>(random())};
  const std::size_t kind = random() % 16;
  return kind < special.size() ? special[kind] : now + static_cast<Tick>(random() % 20);
}

State wild_state(std::mt19937& random) {
  State state{};
  state.world.players = static_cast<std::int32_t>(1 + random() % kMaxPlayers);
  state.world.tick = wild_tick(random, 1000);
  for (int robot = 0; robot < kMaxRobots; ++robot) {
    state.schedule.turn[robot] = wild_tick(random, state.world.tick);
    state.schedule.radio[robot] = wild_tick(random, state.world.tick);
    state.world.bodies[robot].moved = static_cast<std::uint8_t>(state.world.tick + random() % 10);
    state.world.bodies[robot].doing = static_cast<Body::Doing>(random() % 10);
  }
  return state;
}

/// Returns the due robots, found one after the other.
Due due_alone(State& state) {
  Due due;
  const Tick now = state.world.tick;
  for_each_robot(state.world.players, [&](int robot) {
    const Some bit = 1u << robot;
    Tick& turn = state.schedule.turn[robot];
    const Tick until = until_move(state.world.bodies[robot], now), radio = state.schedule.radio[robot];
    const bool moves = turn <= now || until == 0, talks = radio <= now;
    if (!moves && !talks) due.later = std::min({due.later, turn == kNever ? kNever : now + until, radio});
    if (moves || talks) due.any |= bit;
    if (talks) due.radios |= bit;
    const bool removed = !on_field(state.world.bodies[robot]);
    if (moves && !removed) due.moves |= bit;
    if (turn <= now && !removed) due.turns |= bit;
    if (moves && removed) turn = kNever;
  });
  return due;
}

void expect_equal(const Due& due, const Due& expected) {
  EXPECT_EQ(due.moves, expected.moves);
  EXPECT_EQ(due.turns, expected.turns);
  EXPECT_EQ(due.radios, expected.radios);
  EXPECT_EQ(due.any, expected.any);
  EXPECT_EQ(due.later, expected.later);
}

TEST(Due, RobotsInLanesAreDueLikeRobotsAlone) {
  std::mt19937 random(1);
  for (int round = 0; round < 20'000; ++round) {
    State wide = wild_state(random), narrow = wide, alone = wide;
    const Due expected = due_alone(alone);
    expect_equal(due_in(wide), expected);
    only_narrow_lanes = true;
    expect_equal(due_in(narrow), expected);
    only_narrow_lanes = false;
    EXPECT_TRUE(std::ranges::equal(wide.schedule.turn, alone.schedule.turn));
    EXPECT_TRUE(std::ranges::equal(narrow.schedule.turn, alone.schedule.turn));
    if (HasFailure()) FAIL() << "round " << round;
  }
}

TEST(Due, TheNextTickIsTheEarliestOfAllRobots) {
  std::mt19937 random(2);
  for (int round = 0; round < 2000; ++round) {
    State state = wild_state(random);
    const Due due = due_in(state);
    Tick earliest = kNever;
    for_each_robot(state.world.players, [&](int robot) {
      const Tick move = state.world.tick + until_move(state.world.bodies[robot], state.world.tick);
      earliest = std::min(earliest, state.schedule.radio[robot]);
      if (state.schedule.turn[robot] != kNever) earliest = std::min(earliest, move);
    });
    ASSERT_EQ(next_tick(state, due), earliest) << "round " << round;
  }
}

}  // namespace
}  // namespace sim
