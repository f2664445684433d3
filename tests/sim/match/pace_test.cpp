#include "sim/match/pace.h"

#include <gtest/gtest.h>

#include "sim/match/situation.h"
#include "tests/sim/support/games.h"
#include "tests/sim/support/states.h"

namespace sim {
namespace {

using test::choice_of;
using test::setup_of;

TEST(Pace, OfThePlainRunIsEveryTickForEverybody) {
  const auto setup = setup_of(choice_of("spl2012", "baseline", "match", Pace::every_tick));
  State state = test::begun(setup.params, 1);
  referee::Events events;
  for (int i = 0; i < 2000; ++i) {
    step(setup.params, state, events);
    test::for_each_body(state.world, [&](int robot, const Body&) { EXPECT_EQ(state.robots[robot].rest, 0); });
  }
}

TEST(Pace, IsEveryTickWhereItMatters) {
  const auto setup = setup_of(choice_of("spl2025", "baseline", "match", Pace::thinned));
  for (std::uint64_t seed = 0; seed < 200; ++seed) {
    State state = random_situation(setup.params, {seed});
    state.world.ball.velocity = {};
    // who goes for the ball, who stands next to it, who is about to kick, who may touch another
    state.robots[2].mind.role = agent::Role::chaser;
    state.world.bodies[3].position = state.world.ball.position + Vec2{0.5f, 0.3f};
    state.robots[4].command.body = motion::Command::Body::kick;
    state.world.bodies[8].position = state.world.bodies[9].position + Vec2{0, 0.4f};
    for (const int robot : {2, 3, 4, 8, 9}) EXPECT_EQ(ticks_to_next_turn(setup.params, state, robot), 1u) << robot;
  }
}

TEST(Pace, LooksWhereTheBallRolls) {
  const auto setup = setup_of(choice_of("spl2025", "idle", "match", Pace::thinned));
  State state = random_situation(setup.params, {1});
  for (int robot = 0; robot < kMaxRobots; ++robot)
    state.world.bodies[robot].position = {-4.f + static_cast<float>(robot % 7), robot < 7 ? 2.8f : -2.8f};
  state.world.bodies[0].position = {2, 0.2f};
  place(state.world.ball, {0, 0});
  state.world.ball.velocity = {-1.5f, 0};
  EXPECT_GT(ticks_to_next_turn(setup.params, state, 0), 1u);
  state.world.ball.velocity = {1.5f, 0};
  EXPECT_EQ(ticks_to_next_turn(setup.params, state, 0), 1u);
}

TEST(Pace, GivesEqualNumbersTheirTurnsAtOnceAndEverybodyOne) {
  const auto setup = setup_of(choice_of("spl2025", "idle", "match", Pace::thinned));
  State state = random_situation(setup.params, {2});
  place(state.world.ball, {0, -2.9f});
  state.world.ball.velocity = {};
  for (int robot = 0; robot < kMaxRobots; ++robot)
    state.world.bodies[robot].position = {static_cast<float>(robot % 7) - 3, robot < 7 ? 2.7f : 1.5f};
  for (const auto phase : {agent::Game::Phase::playing, agent::Game::Phase::ready, agent::Game::Phase::set}) {
    state.book.phase = phase;
    for (state.world.tick = 0; state.world.tick < 60; ++state.world.tick) {
      int turns = 0;
      for (int player = 1; player <= 5; ++player) {
        const Tick home = ticks_to_next_turn(setup.params, state, robot_of(Side::home, player));
        EXPECT_EQ(home, ticks_to_next_turn(setup.params, state, robot_of(Side::away, player)));
        EXPECT_GE(home, 1u);
        turns += home == 1;
      }
      // not all of them in the same tick
      EXPECT_GE(turns, 1);
      EXPECT_LE(turns, 2);
    }
  }
}

TEST(Pace, IsTheSameInAMirrorAndByOtherNames) {
  const auto setup = setup_of(choice_of("spl2012", "baseline", "match", Pace::thinned));
  const Params other_names = test::exchanged(setup.params);
  for (std::uint64_t seed = 0; seed < 300; ++seed) {
    State state = random_situation(setup.params, {seed});
    state.world.tick = static_cast<Tick>(seed);
    for_each_robot(state.world.players, [&](int robot) {
      const Tick turn = ticks_to_next_turn(setup.params, state, robot);
      EXPECT_EQ(turn, ticks_to_next_turn(setup.params, test::mirrored(state), robot));
      const int other = (robot + kMaxPlayers) % kMaxRobots;
      EXPECT_EQ(turn, ticks_to_next_turn(other_names, test::exchanged(state), other));
    });
  }
}

TEST(Pace, ThinsMostOfTheWorkAway) {
  const auto setup = setup_of(choice_of("spl2012", "baseline", "match", Pace::thinned), 120);
  State state = test::begun(setup.params, 3);
  referee::Events events;
  double turns = 0, robots = 0;
  while (!finished(state)) {
    test::for_each_body(state.world, [&](int robot, const Body&) {
      turns += state.robots[robot].rest == 0;
      ++robots;
    });
    step(setup.params, state, events);
  }
  EXPECT_LT(turns, 0.65 * robots);
}

}  // namespace
}  // namespace sim
