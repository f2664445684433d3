// Tests of walking.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "sim/motion/rhythm.h"
#include "tests/sim/motion/arena.h"
#include "tests/sim/motion/dice.h"

namespace sim::motion {
namespace {

using Doing = Body::Doing;

// how far from its destination a body may stop: the tolerance and the stopping distance
constexpr float kTolerance = 0.02f;

Command random_speed(Dice& dice) {
  const float x = dice.between(-0.4f, 0.4f);
  const float y = dice.between(-0.4f, 0.4f);
  return walk_speed({x, y}, dice.between(-2, 2));
}

Pose2 random_pose(Dice& dice, float reach) {
  const float x = dice.between(-reach, reach);
  const float y = dice.between(-reach, reach);
  return {{x, y}, dice.between(-kPi, kPi)};
}

void place(Body& body, Pose2 pose) {
  body.position = pose.position;
  body.heading = pose.heading;
  body.facing = direction(pose.heading);
}

// 1 at the border of the possible velocities
float share_of_top(const Walk& walk, Vec2 velocity) {
  const float x = velocity.x / (velocity.x >= 0 ? walk.forward : walk.backward);
  const float y = velocity.y / walk.sideward;
  return std::sqrt(x * x + y * y);
}

// [s] until the body has arrived
float arrive(Arena& arena, Pose2 target) {
  for (int tick = 0; tick < 6000; ++tick) {
    const Command command = walk_to(arena.body(), target);
    if (length(command.walk) <= 0.01f && std::abs(command.turn) <= 0.03f) return static_cast<float>(tick) / 30;
    arena.move(command);
  }
  return 1e6f;
}

TEST(Walk, NoBodyIsEverFasterThanItsModelWhateverItsCommandAndNoise) {
  Dice dice{std::mt19937(1)};
  Arena arena;
  arena.model.walk.speed_noise = 0.5f;
  arena.model.walk.turn_noise = 1;
  float fastest = 0;
  for (int command = 0; command < 1000; ++command) {
    const Command order = command % 2 == 0 ? random_speed(dice) : walk_to(arena.body(), random_pose(dice, 3));
    for (int tick = 0; tick < 40; ++tick) {
      const Body before = arena.body();
      arena.move(order);
      const float moved = distance(before.position, arena.body().position) * 30;
      const float turned = std::abs(normalized(arena.body().heading - before.heading)) * 30;
      ASSERT_LE(moved, arena.model.walk.forward + 1e-4f);
      ASSERT_LE(turned, arena.model.walk.turn_rate + 1e-4f);
      ASSERT_LE(share_of_top(arena.model.walk, arena.body().velocity), 1.0001f);
      ASSERT_LE(std::abs(arena.body().turn_rate), arena.model.walk.turn_rate);
      ASSERT_NEAR(distance(arena.body().facing, direction(arena.body().heading)), 0, 2e-6f);
      fastest = std::max(fastest, moved);
    }
  }
  EXPECT_GT(fastest, 0.97f * arena.model.walk.forward);
}

TEST(Walk, EachTopSpeedIsReached) {
  const Walk walk = match_model().walk;
  const struct {
    Vec2 command;
    Vec2 reached;
  } cases[] = {{{9, 0}, {walk.forward, 0}},
               {{-9, 0}, {-walk.backward, 0}},
               {{0, 9}, {0, walk.sideward}},
               {{0, -9}, {0, -walk.sideward}},
               {{0.1f, 0.05f}, {0.1f, 0.05f}}};
  for (const auto& [command, reached] : cases) {
    Arena arena{.effects = no_noise()};
    arena.move(walk_speed(command, 0), 60);
    EXPECT_NEAR(distance(arena.body().velocity, reached), 0, 1e-6f);
  }
}

TEST(Walk, TurningCostsTranslationLinearly) {
  const Walk walk = match_model().walk;
  for (const float share : {-1.f, -0.5f, 0.f, 0.25f, 0.5f, 1.f}) {
    Arena arena{.effects = no_noise()};
    arena.move(walk_speed({1, 0}, share * walk.turn_rate), 60);
    EXPECT_NEAR(arena.body().velocity.x, walk.forward * (1 - walk.turn_cost * std::abs(share)), 1e-6f);
    EXPECT_FLOAT_EQ(arena.body().turn_rate, share * walk.turn_rate);
  }
  Arena arena{.effects = no_noise()};
  arena.effects.walk_acceleration = false;
  arena.move(walk_speed({1, 0}, walk.turn_rate), 60);
  EXPECT_FLOAT_EQ(arena.body().velocity.x, walk.forward) << "without the effect it costs nothing";
}

TEST(Walk, SpeedsChangeNoFasterThanTheirAccelerations) {
  Dice dice{std::mt19937(2)};
  Arena arena;
  const Walk& walk = arena.model.walk;
  for (int command = 0; command < 500; ++command) {
    const Command order = command % 3 == 0 ? Command{} : random_speed(dice);
    for (int tick = 0; tick < 20; ++tick) {
      const Body before = arena.body();
      arena.move(order);
      ASSERT_LE(distance(arena.body().velocity, before.velocity), walk.acceleration / 30 * 1.0001f);
      ASSERT_LE(std::abs(arena.body().turn_rate - before.turn_rate), walk.turn_acceleration / 30 * 1.0001f);
    }
  }
  arena.effects.walk_acceleration = arena.effects.walk_noise = false;
  arena.move(walk_speed({0.25f, 0}, 0), 30);
  arena.move(walk_speed({-0.2f, 0}, 0), Rhythm(walk).until_next(arena.world.tick));
  EXPECT_FLOAT_EQ(arena.body().velocity.x, 0.25f) << "the step is finished";
  arena.move(walk_speed({-0.2f, 0}, 0));
  EXPECT_FLOAT_EQ(arena.body().velocity.x, -0.2f) << "without the effect at once";
}

TEST(Walk, StartsAndStopsWithDelay) {
  Arena arena{.effects = no_noise()};
  const Walk& walk = arena.model.walk;
  const Command go = walk_speed({0.25f, 0}, 0);

  for (Tick tick = 0; tick < ticks(walk.start_delay); ++tick) {
    arena.move(go);
    ASSERT_EQ(arena.body().doing, Doing::starting);
    ASSERT_EQ(arena.body().position, Vec2{});
  }
  arena.move(go);
  EXPECT_EQ(arena.body().doing, Doing::walking);
  EXPECT_GT(arena.body().position.x, 0);

  arena.move(go, 60);
  while (!Rhythm(walk).begins_at(arena.world.tick)) {
    arena.move({});
    ASSERT_EQ(arena.body().doing, Doing::walking) << "the step is finished";
  }
  for (Tick tick = 0; tick < ticks(walk.stop_delay); ++tick) {
    arena.move({});
    ASSERT_EQ(arena.body().doing, Doing::stopping);
  }
  const Vec2 stopped = arena.body().position;
  arena.move({});
  EXPECT_EQ(arena.body().doing, Doing::standing);
  EXPECT_EQ(arena.body().position, stopped);
  EXPECT_EQ(arena.body().velocity, Vec2{});
}

TEST(Walk, AStoppingBodyWalksOnWithTheNextStep) {
  Arena arena{.effects = no_noise()};
  const Command go = walk_speed({0.25f, 0}, 0);
  arena.move(go, 60);
  while (arena.body().doing == Doing::walking) arena.move({});
  ASSERT_EQ(arena.body().doing, Doing::stopping);
  const Rhythm rhythm(arena.model.walk);
  while (!rhythm.begins_at(arena.world.tick)) {
    arena.move(go);
    ASSERT_EQ(arena.body().doing, Doing::stopping);
  }
  arena.move(go);
  EXPECT_EQ(arena.body().doing, Doing::walking);
}

TEST(Walk, AStepIsFinishedDespiteNewCommands) {
  Dice dice{std::mt19937(11)};
  const Rhythm rhythm(match_model().walk);
  for (std::uint64_t seed = 0; seed < 200; ++seed) {
    Arena told{.effects = all_effects()};
    told.world.key.seed = seed;
    told.move(random_speed(dice), 40);
    while (!rhythm.begins_at(told.world.tick)) told.move(walk_speed({0.2f, 0}, 0));
    const Command order = seed % 2 == 0 ? random_speed(dice) : walk_to(told.body(), random_pose(dice, 2));
    told.move(order);
    Arena left = told;
    while (!rhythm.begins_at(told.world.tick)) {
      const Command others[] = {{}, random_speed(dice), walk_to(told.body(), random_pose(dice, 1))};
      told.move(others[told.world.tick % 3]);
      left.move(order);
    }
    EXPECT_EQ(told.body().position, left.body().position) << seed;
    EXPECT_EQ(told.body().heading, left.body().heading);
    EXPECT_EQ(told.body().velocity, left.body().velocity);
  }
}

TEST(Walk, StepsBeginInTheirRhythm) {
  for (const float duration : {0.1f, 0.235f, 0.25f, 0.525f, 2.f}) {
    Walk walk = match_model().walk;
    walk.step_duration = duration;
    const Rhythm rhythm(walk);
    Tick begun = 0;
    for (Tick tick = 0; tick < 3000; ++tick) {
      EXPECT_EQ(rhythm.begins_at(tick), tick == 0 || rhythm.step_at(tick) != rhythm.step_at(tick - 1));
      const Tick next = tick + rhythm.until_next(tick);
      EXPECT_TRUE(rhythm.begins_at(next));
      EXPECT_EQ(rhythm.step_at(next), rhythm.step_at(tick) + 1);
      begun += rhythm.begins_at(tick) ? 1 : 0;
    }
    EXPECT_NEAR(static_cast<float>(begun), 100 / duration, 2);
  }
}

TEST(Walk, WithoutDelayAndAccelerationItGoesAtOnceAndStandsWhenTheStepEnds) {
  Arena arena{.effects = Effects{}};
  arena.move(walk_speed({0.25f, 0}, 0));
  EXPECT_EQ(arena.body().doing, Doing::walking);
  EXPECT_FLOAT_EQ(arena.body().position.x, 0.25f / 30);
  arena.move({}, 7);
  EXPECT_EQ(arena.body().doing, Doing::walking);
  arena.move({});
  EXPECT_EQ(arena.body().doing, Doing::standing);
  EXPECT_FLOAT_EQ(arena.body().position.x, 8 * 0.25f / 30);
}

TEST(Walk, ManyTicksAtOnceEqualManySingleTicks) {
  Dice dice{std::mt19937(3)};
  for (int i = 0; i < 300; ++i) {
    Arena once{.effects = no_noise()};
    if (i % 2 == 1) once.effects = all_effects();
    once.world.tick = static_cast<Tick>(i);
    place(once.body(), random_pose(dice, 2));
    Arena often = once;
    for (int command = 0; command < 10; ++command) {
      const Command order = command == 4 ? Command{} : random_speed(dice);
      once.move(order, 6);
      for (int tick = 0; tick < 6; ++tick) often.move(order);
      ASSERT_NEAR(distance(once.body().position, often.body().position), 0, 1e-3f * static_cast<float>(command + 1));
      ASSERT_NEAR(normalized(once.body().heading - often.body().heading), 0, 1e-4f);
      ASSERT_NEAR(distance(once.body().velocity, often.body().velocity), 0, 1e-5f);
      ASSERT_NEAR(once.body().walked, often.body().walked, 2e-3f * static_cast<float>(command + 1));
      ASSERT_EQ(once.body().doing, often.body().doing);
      ASSERT_EQ(once.body().since, often.body().since);
    }
  }
}

TEST(Walk, AtConstantSpeedOneLongTickIsTheArc) {
  Arena arena{.effects = Effects{}};
  const Vec2 velocity{0.2f, 0.1f};
  const float turn = 1;
  arena.move(walk_speed(velocity, turn), 30);
  // the arc about the centre of rotation
  const Vec2 pivot{-velocity.y / turn, velocity.x / turn};
  const Vec2 end = pivot - turned(pivot, direction(1));
  EXPECT_NEAR(distance(arena.body().position, end), 0, 3e-4f);
  EXPECT_NEAR(arena.body().heading, 1, 1e-6f);
}

TEST(Walk, AWalkOfSeveralTicksFollowsItsDestinationWithoutNewCommands) {
  Dice dice{std::mt19937(4)};
  for (int i = 0; i < 200; ++i) {
    Arena often{.effects = no_noise()};
    place(often.body(), random_pose(dice, 2));
    Arena seldom = often;
    const Pose2 target = random_pose(dice, 2);
    for (int decision = 0; decision < 150; ++decision) {
      seldom.move(walk_to(seldom.body(), target), 4);
      for (int tick = 0; tick < 4; ++tick) often.move(walk_to(often.body(), target));
      ASSERT_NEAR(distance(often.body().position, seldom.body().position), 0, 0.07f) << i << " " << decision;
    }
    Arena whole = often;
    place(whole.body(), random_pose(dice, 2));
    whole.move(walk_to(whole.body(), target), 1800);
    EXPECT_NEAR(distance(whole.body().position, target.position), 0, kTolerance);
    EXPECT_NEAR(normalized(whole.body().heading - target.heading), 0, 0.05f);
  }
}

TEST(Walk, ArrivesWithoutOvershootingAndStands) {
  Dice dice{std::mt19937(5)};
  for (int i = 0; i < 200; ++i) {
    Arena arena{.effects = i % 2 == 0 ? no_noise() : all_effects()};
    arena.world.key.seed = static_cast<std::uint64_t>(i);
    const Pose2 target = random_pose(dice, i % 4 < 2 ? 3.f : 0.3f);
    const Vec2 way = target.position;
    EXPECT_LT(arrive(arena, target), 60);
    float beyond = 0;
    for (int tick = 0; tick < 60; ++tick) {
      arena.move(walk_to(arena.body(), target));
      beyond = std::max(beyond, dot(arena.body().position - target.position, way) / length(way));
    }
    EXPECT_LT(beyond, kTolerance);
    EXPECT_EQ(arena.body().doing, Doing::standing);
    EXPECT_NEAR(distance(arena.body().position, target.position), 0, kTolerance);
    EXPECT_NEAR(normalized(arena.body().heading - target.heading), 0, 0.06f);
  }
}

TEST(Walk, ArrivesWithAnyEffectSwitchedOff) {
  for (int off = 0; off < 8; ++off) {
    Arena arena;
    arena.effects.walk_acceleration = (off & 1) == 0;
    arena.effects.walk_noise = (off & 2) == 0;
    arena.effects.walk_delay = (off & 4) == 0;
    EXPECT_LT(arrive(arena, {{-1, 0.7f}, 2}), 20) << off;
  }
}

TEST(Walk, FacesADistantDestination) {
  Arena arena{.effects = no_noise()};
  const Pose2 target{{2, 2}, -1};
  for (int tick = 0; tick < 120; ++tick) arena.move(walk_to(arena.body(), target));
  EXPECT_NEAR(arena.body().heading, kPi / 4, 0.03f);
  EXPECT_NEAR(arena.body().velocity.y, 0, 0.01f);
}

TEST(Walk, WalksInAnyDirectionToANearDestination) {
  Arena arena{.effects = no_noise()};
  const Pose2 target{{-0.2f, 0.25f}, 0};
  while (arena.world.tick < 150) {
    arena.move(walk_to(arena.body(), target));
    ASSERT_EQ(arena.body().heading, 0);
  }
  EXPECT_NEAR(distance(arena.body().position, target.position), 0, kTolerance);
}

TEST(Walk, GainIsTheShareOfTheTopSpeed) {
  Arena arena{.effects = no_noise()};
  Command command = walk_to(arena.body(), {{3, 0}, 0});
  command.gain = 0.4f;
  arena.move(command, 90);
  EXPECT_NEAR(arena.body().velocity.x, 0.4f * arena.model.walk.forward, 1e-6f);
}

TEST(Walk, AMirroredWalkIsTheMirrorImageToTheBit) {
  Dice dice{std::mt19937(8)};
  for (int i = 0; i < 100; ++i) {
    Arena left{.effects = no_noise()};
    Arena right = left;
    const Pose2 start = random_pose(dice, 2);
    place(left.body(), start);
    place(right.body(), {{start.position.x, -start.position.y}, -start.heading});
    for (int command = 0; command < 20; ++command) {
      Command order = random_speed(dice);
      if (command % 2 == 0) order = walk_to(left.body(), random_pose(dice, 2));
      Command mirrored = order;
      mirrored.walk.y = -order.walk.y;
      mirrored.turn = -order.turn;
      const Tick steps = command % 3 == 0 ? 1 : 11;
      left.move(order, steps);
      right.move(mirrored, steps);
      const Body& l = left.body();
      const Body& r = right.body();
      ASSERT_EQ(l.position, (Vec2{r.position.x, -r.position.y}));
      ASSERT_EQ(l.facing, (Vec2{r.facing.x, -r.facing.y}));
      ASSERT_EQ(l.velocity, (Vec2{r.velocity.x, -r.velocity.y}));
      ASSERT_EQ(l.heading, -r.heading);
      ASSERT_EQ(l.turn_rate, -r.turn_rate);
      ASSERT_EQ(l.walked, r.walked);
      ASSERT_EQ(l.doing, r.doing);
    }
  }
}

TEST(Walk, TurnsEitherWayToADestinationStraightBehind) {
  for (const float zero : {0.f, -0.f}) {
    Arena arena{.effects = no_noise()};
    Command command;
    command.body = Command::Body::walk_to;
    command.walk = {-2, zero};
    arena.move(command, 30);
    EXPECT_EQ(std::signbit(arena.body().heading), std::signbit(zero));
    EXPECT_GT(std::abs(arena.body().heading), 0.5f);
  }
}

TEST(Walk, NoiseIsDrawnOncePerStep) {
  Arena arena;
  arena.move(walk_speed({0.1f, 0}, 0), 15);
  int changes = 0;
  for (int tick = 0; tick < 300; ++tick) {
    const Vec2 step = arena.body().step_velocity;
    arena.move(walk_speed({0.1f, 0}, 0));
    changes += step == arena.body().step_velocity ? 0 : 1;
  }
  EXPECT_EQ(changes, 40) << "ten seconds of steps of a quarter of a second";
}

TEST(Walk, NoiseHasTheDeviationOfTheModel) {
  double sum = 0, squares = 0, turns = 0;
  const int count = 4000;
  for (int seed = 0; seed < count; ++seed) {
    Arena arena;
    arena.world.key.seed = static_cast<std::uint64_t>(seed);
    arena.effects.walk_delay = false;
    arena.move(walk_speed({0.1f, 0}, 0));
    const double deviation = arena.body().step_velocity.x / 0.1f - 1;
    sum += deviation, squares += deviation * deviation;
    const double turn = arena.body().step_turn_rate;
    turns += turn * turn;
  }
  EXPECT_NEAR(sum / count, 0, 0.01);
  EXPECT_NEAR(std::sqrt(squares / count), 0.15, 0.006);
  EXPECT_NEAR(std::sqrt(turns / count), 0.1, 0.004);
}

TEST(Walk, WithoutTheEffectThereIsNoNoise) {
  Arena first{.effects = no_noise()};
  Arena second{.effects = no_noise()};
  second.world.key.seed = 99;
  first.move(walk_speed({0.2f, 0.1f}, 0.3f), 100);
  second.move(walk_speed({0.2f, 0.1f}, 0.3f), 100);
  EXPECT_EQ(first.body().position, second.body().position);
  EXPECT_EQ(first.body().step_velocity, second.body().step_velocity);
}

TEST(Walk, WalkedIsTheLengthOfThePath) {
  Dice dice{std::mt19937(9)};
  Arena arena;
  float path = 0;
  for (int command = 0; command < 100; ++command) {
    const Command order = random_speed(dice);
    for (int tick = 0; tick < 20; ++tick) {
      const Vec2 before = arena.body().position;
      arena.move(order);
      path += distance(before, arena.body().position);
    }
  }
  EXPECT_NEAR(arena.body().walked, path, 1e-3f * path);
  EXPECT_GT(path, 1);
}

TEST(Walk, ARemovedBodyDoesNothing) {
  Arena arena;
  arena.effects.falls = true;
  arena.body().doing = Doing::removed;
  Command command = walk_speed({0.2f, 0}, 1);
  command.head = Command::Head::angles;
  command.look[0] = 1;
  const Body before = arena.body();
  arena.move(command, 50);
  command.body = Command::Body::kick;
  arena.move(command, 50);
  const Body& now = arena.body();
  EXPECT_EQ(now.doing, Doing::removed);
  EXPECT_EQ(now.position, before.position);
  EXPECT_EQ(now.heading, before.heading);
  EXPECT_EQ(now.velocity, before.velocity);
  EXPECT_EQ(now.head_yaw, before.head_yaw);
  EXPECT_EQ(now.since, before.since);
  EXPECT_EQ(now.walked, before.walked);
}

TEST(Walk, OtherBodiesStayUnchanged) {
  Arena arena;
  const World before = arena.world;
  arena.move(walk_speed({0.2f, 0}, 1), 50);
  for (int robot = 0; robot < kMaxRobots; ++robot) {
    if (robot != Arena::kRobot) {
      EXPECT_EQ(arena.world.bodies[robot].position, before.bodies[robot].position);
    }
  }
}

/// Returns the speed [m/s] of a robot after `duration` [s] straight ahead.
float speed_ahead(std::uint64_t seed, bool spread, float duration) {
  Arena arena{.effects = no_noise()};
  arena.effects.walk_spread = spread;
  arena.world.key.seed = seed;
  for (Tick tick = 0; tick < ticks(duration); ++tick) arena.move(walk_speed({1, 0}, 0));
  return arena.body().velocity.x;
}

TEST(Walk, EachRobotHasItsOwnTopSpeedForAWholeGame) {
  const Walk walk = match_model().walk;
  const int count = 500;
  float least = 1, most = 0, sum = 0;
  for (int seed = 0; seed < count; ++seed) {
    const auto key = static_cast<std::uint64_t>(seed);
    const float speed = speed_ahead(key, true, 2);
    if (seed < 20) {
      EXPECT_EQ(speed_ahead(key, true, 9), speed) << "the same later in the game";
    }
    least = std::min(least, speed), most = std::max(most, speed), sum += speed;
  }
  EXPECT_GT(least, (1 - walk.spread) * walk.forward * 0.999f);
  EXPECT_LT(most, walk.forward);
  EXPECT_NEAR(least, (1 - walk.spread) * walk.forward, 0.005f);
  EXPECT_NEAR(most, walk.forward, 0.005f);
  EXPECT_NEAR(sum / count, (1 - 0.5f * walk.spread) * walk.forward, 0.005f) << "all between are equally likely";
  EXPECT_EQ(speed_ahead(3, false, 2), walk.forward) << "without the effect all are equal";
}

}  // namespace
}  // namespace sim::motion
