#include "sim/match/pace.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "sim/match/fields.h"
#include "sim/match/play.h"
#include "sim/match/situation.h"
#include "sim/motion/rhythm.h"
#include "tests/sim/support/games.h"
#include "tests/sim/support/states.h"

namespace sim {
namespace {

using test::choice_of;
using test::setup_of;

TEST(Pace, EveryTickMeansEveryTickForAllRobots) {
  const auto setup = setup_of(choice_of("spl2012", "baseline", "match", Pace::every_tick));
  State state = test::begun(setup.params, 1);
  referee::Events events;
  for (int i = 0; i < 2000; ++i) {
    step(setup.params, state, events);
    test::for_each_body(state.world,
                        [&](int robot, const Body&) { EXPECT_EQ(state.schedule.turn[robot], state.world.tick); });
  }
}

TEST(Pace, IsFastNextToTheBallAndToRobots) {
  const auto setup = setup_of(choice_of("spl2025", "baseline", "match", Pace::thinned));
  const float radius = setup.params.teams[0].models.contact.robot_radius;
  for (std::uint64_t seed = 0; seed < 200; ++seed) {
    State state = random_situation(setup.params, {seed});
    state.world.tick = static_cast<Tick>(seed);
    state.world.ball.velocity = {};
    state.world.bodies[3].position = state.world.ball.position + Vec2{0.2f, 0.2f};
    state.world.bodies[8].position = state.world.bodies[9].position + Vec2{0, 2 * radius + 0.05f};
    EXPECT_LE(wait_of(setup.params, state, 3).turn, 2u);
    for (const int robot : {8, 9}) {
      state.robots[robot].command.body = motion::Command::Body::walk_to;
      EXPECT_LE(wait_of(setup.params, state, robot).turn, 4u) << robot;
      state.world.bodies[robot].doing = Body::Doing::walking;
      EXPECT_LE(wait_of(setup.params, state, robot).move, 4u) << robot;
    }
  }
}

TEST(Pace, OfAWalkingRobotFollowsItsSteps) {
  const auto setup = setup_of(choice_of("spl2025", "baseline", "match", Pace::thinned));
  const motion::Rhythm rhythm(setup.params.teams[0].models.motion.walk);
  for (std::uint64_t seed = 0; seed < 200; ++seed) {
    State state = random_situation(setup.params, {seed});
    state.world.ball.velocity = {};
    const float away = 0.205f + 0.01f * static_cast<float>(seed);
    for_each_robot(state.world.players, [&](int robot) {
      state.world.tick = static_cast<Tick>(seed) * 7;
      state.world.bodies[robot].doing = Body::Doing::walking;
      state.world.bodies[robot].position = state.world.ball.position + Vec2{away, 0};
      const Wait wait = wait_of(setup.params, state, robot);
      // next to the ball it has one more turn in between
      const Tick sooner = state.book.phase != agent::Game::Phase::playing ? 18 : away < 0.6f ? 4 : away < 0.8f ? 6 : 18;
      EXPECT_TRUE(wait.turn == sooner || rhythm.begins_at(state.world.tick + wait.turn)) << away << ": " << wait.turn;
      EXPECT_LE(wait.turn, sooner);
      EXPECT_GE(wait.move, 1u);
      EXPECT_LE(wait.move, wait.turn);
      EXPECT_LE(wait.turn, 2u * 8);
      // a command in the middle of a step takes effect with the next step
      state.robots[robot].command.body = motion::Command::Body::kick;
      const bool begins = rhythm.begins_at(state.world.tick);
      const Wait kick = wait_of(setup.params, state, robot);
      const Tick delay = ticks(setup.params.teams[0].models.motion.kicks[0].delay);
      EXPECT_EQ(kick.turn, begins ? delay : std::min(rhythm.until_next(state.world.tick), sooner));
      state.world.bodies[robot].position = {0, 100};
    });
  }
}

TEST(Pace, WaitsForTheFootOfAKick) {
  const auto setup = setup_of(choice_of("spl2025", "baseline", "match", Pace::thinned));
  const Tick delay = ticks(setup.params.teams[0].models.motion.kicks[0].delay);
  State state = random_situation(setup.params, {1});
  state.world.tick = 100;
  state.robots[1].command.body = motion::Command::Body::kick;
  EXPECT_EQ(wait_of(setup.params, state, 1).turn, delay);

  Body& body = state.world.bodies[1];
  body.doing = Body::Doing::kicking;
  body.since = 100;
  for (state.world.tick = 101; state.world.tick < 100 + delay; ++state.world.tick)
    EXPECT_EQ(wait_of(setup.params, state, 1).turn, 100 + delay - state.world.tick);
  EXPECT_EQ(wait_of(setup.params, state, 1).turn, 1u) << "the tick in which it passes";
  body.kick_done = true;
  place(state.world.ball, body.position + Vec2{0, 3});
  state.robots[1].command = {};
  EXPECT_GT(wait_of(setup.params, state, 1).turn, 1u);
}

TEST(Pace, OfAStandingRobotNearTheBallsPathIsEverySecondTick) {
  const auto setup = setup_of(choice_of("spl2025", "baseline", "match", Pace::thinned));
  State state = random_situation(setup.params, {4});
  Body& body = state.world.bodies[0];
  body = {};
  place(state.world.ball, {0, 0});
  state.world.ball.velocity = {-2, 0};
  for (state.world.tick = 0; state.world.tick < 36; ++state.world.tick) {
    body.position = {-1.8f, 1.1f};
    EXPECT_LE(wait_of(setup.params, state, 0).turn, 2u);
    body.position = {1.1f, 0};
    EXPECT_LE(wait_of(setup.params, state, 0).turn, 2u);
    body.position = {-1.8f, 1.3f};
    EXPECT_EQ(wait_of(setup.params, state, 0).turn, 18 - state.world.tick % 18);
  }
}

TEST(Pace, IsLowerTheFartherFromTheBall) {
  const auto setup = setup_of(choice_of("spl2025", "baseline", "match", Pace::thinned));
  State state = random_situation(setup.params, {3});
  for (int robot = 0; robot < kMaxRobots; ++robot)
    state.world.bodies[robot].position = {static_cast<float>(robot % 7) - 3, robot < 7 ? 2.7f : 1.5f};
  place(state.world.ball, {0, -2});
  Tick slowest = 0;
  for (float away = 0.3f; away < 3; away += 0.05f) {
    state.world.bodies[0].position = state.world.ball.position + Vec2{away, 0};
    Tick longest = 0;
    for (state.world.tick = 0; state.world.tick < 30; ++state.world.tick)
      longest = std::max(longest, wait_of(setup.params, state, 0).turn);
    EXPECT_GE(longest, slowest) << away;
    slowest = longest;
  }
  EXPECT_EQ(slowest, 18u);

  // the chaser waits less
  state.robots[0].mind.role = agent::Role::chaser;
  for (state.world.tick = 0; state.world.tick < 30; ++state.world.tick)
    EXPECT_LE(wait_of(setup.params, state, 0).turn, 9u);
}

TEST(Pace, GivesAllRobotsATurnWhenPlayBegins) {
  const auto setup = setup_of(choice_of("spl2012", "baseline", "match", Pace::thinned));
  State state = test::begun(setup.params, 5);
  const auto is_playing = [](const State& now) { return now.book.phase == agent::Game::Phase::playing; };
  play(setup.params, state, is_playing, [](const referee::Event&) {});
  test::for_each_body(
      state.world, [&](int robot, const Body&) { EXPECT_EQ(state.schedule.turn[robot], state.world.tick) << robot; });
}

TEST(Pace, FollowsThePathOfTheBall) {
  const auto setup = setup_of(choice_of("spl2025", "idle", "match", Pace::thinned));
  State state = random_situation(setup.params, {1});
  for (int robot = 0; robot < kMaxRobots; ++robot)
    state.world.bodies[robot].position = {-4.f + static_cast<float>(robot % 7), robot < 7 ? 2.8f : -2.8f};
  state.world.bodies[0].position = {2, 0.2f};
  place(state.world.ball, {0, 0});
  state.world.ball.velocity = {-1.5f, 0};
  state.world.tick = 0;
  EXPECT_EQ(wait_of(setup.params, state, 0).turn, 18u);
  state.world.ball.velocity = {1.5f, 0};
  EXPECT_EQ(wait_of(setup.params, state, 0).turn, 2u);
}

TEST(Pace, GivesBothSidesTheirTurnsInTheSameTicks) {
  const auto setup = setup_of(choice_of("spl2025", "idle", "match", Pace::thinned));
  State state = random_situation(setup.params, {2});
  place(state.world.ball, {0, -2.9f});
  state.world.ball.velocity = {};
  for (int robot = 0; robot < kMaxRobots; ++robot)
    state.world.bodies[robot].position = {static_cast<float>(robot % 7) - 3, robot < 7 ? 2.7f : 1.5f};
  // in SET, long before its end
  state.book.phase_since = 1000;
  for (const auto phase : {agent::Game::Phase::playing, agent::Game::Phase::ready, agent::Game::Phase::set}) {
    state.book.phase = phase;
    for (state.world.tick = 0; state.world.tick < 60; ++state.world.tick) {
      const Tick first = wait_of(setup.params, state, 0).turn;
      EXPECT_GE(first, 1u);
      for_each_robot(5, [&](int robot) { EXPECT_EQ(wait_of(setup.params, state, robot).turn, first); });
    }
  }
}

TEST(Pace, IsTheSameMirroredAndWithExchangedSides) {
  const auto setup = setup_of(choice_of("spl2012", "baseline", "match", Pace::thinned));
  const Params other_names = test::exchanged(setup.params);
  for (std::uint64_t seed = 0; seed < 300; ++seed) {
    State state = random_situation(setup.params, {seed});
    state.world.tick = static_cast<Tick>(seed);
    for_each_robot(state.world.players, [&](int robot) {
      const Tick turn = wait_of(setup.params, state, robot).turn;
      EXPECT_EQ(turn, wait_of(setup.params, test::mirrored(state), robot).turn);
      const int other = (robot + kMaxPlayers) % kMaxRobots;
      EXPECT_EQ(turn, wait_of(other_names, test::exchanged(state), other).turn);
    });
  }
}

TEST(Pace, SavesMostOfTheTurns) {
  const auto setup = setup_of(choice_of("spl2012", "baseline", "match", Pace::thinned), 120);
  State state = test::begun(setup.params, 3);
  referee::Events events;
  double turns = 0, robots = 0;
  while (!finished(state)) {
    test::for_each_body(state.world, [&](int robot, const Body&) {
      turns += state.schedule.turn[robot] == state.world.tick;
      ++robots;
    });
    step(setup.params, state, events);
  }
  EXPECT_LT(turns, 0.2 * robots);
}

TEST(Pace, InterpolatesBodiesBetweenTurns) {
  const auto setup = setup_of(choice_of("spl2025", "idle", "match", Pace::thinned));
  State state = random_situation(setup.params, {6});
  state.world.tick = 100;
  Body& body = state.world.bodies[2];
  state.robots[2].cognition.last = {{1, 1}, 3};
  body.position = {1.4f, 0.8f};
  body.heading = -3;
  body.facing = direction(-3);
  state.schedule.lag[2] = 4;
  for (Tick rested = 0; rested <= 4; ++rested) {
    state.schedule.turn[2] = 104 - rested;
    body.moved = static_cast<std::uint8_t>(104 - rested);
    const Body shown = between_turns(state).bodies[2];
    const float share = static_cast<float>(rested) / 4;
    EXPECT_NEAR(distance(shown.position, Vec2{1 + 0.4f * share, 1 - 0.2f * share}), 0, 1e-6f);
    EXPECT_NEAR(normalized(shown.heading - (3 + share * (2 * kPi - 6))), 0, 1e-5f);
    EXPECT_NEAR(distance(shown.facing, direction(shown.heading)), 0, 1e-6f);
  }
  state.world.bodies[2].doing = Body::Doing::removed;
  state.schedule.turn[2] = kNever;
  EXPECT_EQ(between_turns(state).bodies[2].position, state.world.bodies[2].position);
}

TEST(Pace, OfEveryTickNeedsNoInterpolation) {
  const auto setup = setup_of(choice_of("spl2012", "baseline", "match", Pace::every_tick));
  State state = test::begun(setup.params, 1);
  referee::Events events;
  for (int i = 0; i < 500; ++i) {
    step(setup.params, state, events);
    State shown = state;
    shown.world = between_turns(state);
    ASSERT_EQ(difference(shown, state), "");
  }
}

}  // namespace
}  // namespace sim
