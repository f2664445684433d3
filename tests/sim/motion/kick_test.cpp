// Tests of kicks.
#include "sim/motion/kick.h"

#include <gtest/gtest.h>

#include <cmath>

#include "sim/motion/rhythm.h"
#include "tests/sim/motion/arena.h"

namespace sim::motion {
namespace {

using Doing = Body::Doing;

Command kick_command(int kick, bool left) {
  Command command;
  command.body = Command::Body::kick;
  command.kick = static_cast<std::uint8_t>(kick);
  command.kick_left = left;
  return command;
}

// kicks a ball that is `off` the middle of the gate, in units of the gate; ends at the impact
struct Shot {
  Arena arena;
  Command command;
  Vec2 velocity;  // [m/s, robot]
  Tick impact = 0;

  Shot(Effects effects, int kick, bool left, Vec2 off, std::uint64_t seed = 0, float gain = 1, float partial = 0.6f)
      : arena{.effects = effects}, command(kick_command(kick, left)) {
    arena.world.key.seed = seed;
    arena.model.hits.partial = partial;
    Body& body = arena.body();
    body.position = {1, -0.5f};
    body.heading = 2;
    body.facing = direction(2);
    command.gain = gain;
    const Kick& table = arena.model.kicks[kick];
    Vec2 ball{table.ball_x + off.x * table.gate_x, table.ball_y + off.y * table.gate_y};
    if (!left) ball.y = -ball.y;
    arena.world.ball.position = body.position + turned(ball, body.facing);
    while (!body.kick_done && impact < 100) {
      arena.move(command);
      ++impact;
    }
    velocity = turned_back(arena.world.ball.velocity, body.facing);
  }

  float range() const { return squared_length(velocity) / (2 * arena.ball.deceleration); }
  bool hit() const { return arena.world.kicked == Arena::kRobot; }
  bool whiffed() const { return arena.world.whiffed == Arena::kRobot; }
};

TEST(Kick, HitsTheBallAfterItsDelayAndEndsAfterItsDuration) {
  for (int kick = 0; kick < 3; ++kick) {
    Shot shot(no_noise(), kick, true, {});
    const Kick& table = shot.arena.model.kicks[kick];
    EXPECT_EQ(shot.impact, ticks(table.delay) + 1) << "in the tick that begins with it";
    EXPECT_TRUE(shot.hit());
    EXPECT_FALSE(shot.whiffed());
    EXPECT_EQ(shot.arena.world.touched, Arena::kRobot);
    while (shot.arena.body().doing == Doing::kicking) shot.arena.move(Command{});
    EXPECT_EQ(shot.arena.world.tick, ticks(table.duration));
    EXPECT_EQ(shot.arena.body().since, ticks(table.duration));
  }
}

TEST(Kick, SomeHitsArePartialAndGiveAnyShareOfTheSpeed) {
  Effects effects = no_noise();
  effects.partial_hits = true;
  const int count = 4000;
  int full = 0, slow = 0;
  for (int seed = 0; seed < count; ++seed) {
    const Shot shot(effects, 0, true, {}, static_cast<std::uint64_t>(seed));
    const float top = std::sqrt(2 * shot.arena.ball.deceleration * shot.arena.model.kicks[0].range);
    const float share = length(shot.velocity) / top;
    ASSERT_LE(share, 1.0001f);
    EXPECT_TRUE(shot.hit()) << "a partial hit is a hit";
    full += share > 0.9999f ? 1 : 0;
    slow += share < 0.5f ? 1 : 0;
  }
  // 60 % are partial, and half of those give less than half of the speed
  EXPECT_NEAR(static_cast<float>(full) / count, 0.4f, 0.03f);
  EXPECT_NEAR(static_cast<float>(slow) / count, 0.3f, 0.03f);
}

TEST(Kick, APartialHitSpreadsTheDirection) {
  const auto deviation = [](float partial) {
    float sum = 0;
    const int count = 2000;
    for (int seed = 0; seed < count; ++seed) {
      Effects effects = all_effects();
      effects.partial_hits = partial > 0;
      const Shot shot(effects, 0, true, {}, static_cast<std::uint64_t>(seed), 1, partial);
      const float angle = angle_of(shot.velocity);
      sum += angle * angle;
    }
    return std::sqrt(sum / count);
  };
  const Arena arena;
  const float table = arena.model.kicks[0].direction_deviation, spread = arena.model.hits.spread;
  EXPECT_NEAR(deviation(0), table, 0.01f);
  // the mean square of a factor that is uniform between 1 and `spread`
  EXPECT_NEAR(deviation(1), table * std::sqrt((spread * spread + spread + 1) / 3), 0.01f);
}

TEST(Kick, SendsTheBallAsTheTableSays) {
  for (int kick = 0; kick < 3; ++kick) {
    for (const bool left : {true, false}) {
      for (const float gain : {0.3f, 1.f}) {
        Shot shot(no_noise(), kick, left, {0.9f, -0.9f}, 0, gain);
        const Kick& table = shot.arena.model.kicks[kick];
        EXPECT_NEAR(shot.range(), gain * table.range, 1e-4f);
        EXPECT_NEAR(angle_of(shot.velocity), left ? table.direction : -table.direction, 1e-5f);
      }
    }
  }
}

TEST(Kick, SpreadsAsTheTableSays) {
  const int count = 4000;
  for (int kick = 0; kick < 3; ++kick) {
    double range = 0, range_squares = 0, angle = 0, angle_squares = 0;
    const Kick table = match_model().kicks[kick];
    for (int seed = 0; seed < count; ++seed) {
      Shot shot(all_effects(), kick, seed % 2 == 0, {}, static_cast<std::uint64_t>(seed));
      const double share = static_cast<double>(shot.range() / table.range);
      const float mirrored = shot.command.kick_left ? shot.velocity.y : -shot.velocity.y;
      const double off = static_cast<double>(atan2(mirrored, shot.velocity.x) - table.direction);
      range += share, range_squares += share * share;
      angle += off, angle_squares += off * off;
    }
    const auto deviation = [&](double sum, double squares) {
      return std::sqrt(squares / count - sum / count * (sum / count));
    };
    const auto expected_range = static_cast<double>(table.range_deviation);
    const auto expected_angle = static_cast<double>(table.direction_deviation);
    EXPECT_NEAR(range / count, 1, 4 * expected_range / std::sqrt(count));
    EXPECT_NEAR(angle / count, 0, 4 * expected_angle / std::sqrt(count));
    EXPECT_NEAR(deviation(range, range_squares), expected_range, 0.05 * expected_range);
    EXPECT_NEAR(deviation(angle, angle_squares), expected_angle, 0.05 * expected_angle);
  }
}

TEST(Kick, IsWeakerOutsideItsGateAndMissesBeyondTwiceItsSize) {
  for (int kick = 0; kick < 3; ++kick) {
    for (const Vec2 way : {Vec2{1, 0}, Vec2{-1, 0}, Vec2{0, 1}, Vec2{0, -1}, Vec2{1, 1}}) {
      const float whole = Shot(no_noise(), kick, true, 0.99f * way).range();
      EXPECT_NEAR(whole, match_model().kicks[kick].range, 1e-4f);
      float last = whole + 1e-4f;
      for (const float off : {1.01f, 1.25f, 1.5f, 1.75f, 1.99f}) {
        Shot shot(no_noise(), kick, true, off * way);
        EXPECT_TRUE(shot.hit());
        EXPECT_LT(shot.range(), last);
        last = shot.range();
      }
      EXPECT_NEAR(last, 0.5f * whole, 0.02f * whole);
      Shot missed(no_noise(), kick, true, 2.01f * way);
      EXPECT_FALSE(missed.hit());
      EXPECT_TRUE(missed.whiffed());
      EXPECT_EQ(missed.velocity, Vec2{});
      EXPECT_EQ(missed.arena.world.touched, kNobody);
    }
  }
}

TEST(Kick, SpreadsMoreOutsideItsGate) {
  double inside = 0, outside = 0;
  for (std::uint64_t seed = 0; seed < 500; ++seed) {
    const auto angle = [&](Vec2 off) {
      return static_cast<double>(angle_of(Shot(all_effects(), 0, true, off, seed).velocity));
    };
    inside += angle({}) * angle({});
    outside += angle({1.5f, 0}) * angle({1.5f, 0});
  }
  EXPECT_NEAR(std::sqrt(outside / inside), 2, 0.01)
      << "half way out the deviation doubles, with the same random numbers";
}

TEST(Kick, TheRightFootNeedsTheBallOnTheRight) {
  Arena arena{.effects = no_noise()};
  const Kick& table = arena.model.kicks[2];
  arena.world.ball.position = {table.ball_x, table.ball_y};
  arena.move(kick_command(2, false), ticks(table.duration));
  EXPECT_EQ(arena.world.whiffed, Arena::kRobot);
}

TEST(Kick, WithoutWhiffItHitsEveryBallInFrontWithinReach) {
  Effects effects = no_noise();
  effects.kick_whiff = false;
  const struct {
    Vec2 ball;
    bool hit;
  } cases[] = {{{0.05f, -0.2f}, true},
               {{0.24f, 0}, true},
               {{0.1f, 0.2f}, true},
               {{0.3f, 0.1f}, false},
               {{-0.05f, 0.05f}, false}};
  for (const auto& [ball, hit] : cases) {
    Arena arena{.effects = effects};
    arena.world.ball.position = ball;
    arena.move(kick_command(0, true), ticks(arena.model.kicks[0].duration));
    EXPECT_EQ(arena.world.kicked == Arena::kRobot, hit) << ball.x << " " << ball.y;
    EXPECT_EQ(arena.world.whiffed == Arena::kRobot, !hit);
    if (hit) {
      EXPECT_NEAR(squared_length(arena.world.ball.velocity) / 0.6f, arena.model.kicks[0].range, 1e-4f);
    }
  }
}

TEST(Kick, CannotBeInterrupted) {
  Arena arena{.effects = no_noise()};
  arena.move(walk_speed({0.2f, 0}, 0), 60);
  while (!Rhythm(arena.model.walk).begins_at(arena.world.tick)) {
    arena.move(kick_command(0, true));
    ASSERT_EQ(arena.body().doing, Doing::walking) << "the step is finished";
  }
  arena.move(kick_command(0, true));
  const Body begun = arena.body();
  EXPECT_EQ(begun.doing, Doing::kicking);
  for (const Command& command : {Command{}, walk_speed({0.2f, 0}, 1), kick_command(1, false)}) {
    arena.move(command, 10);
    EXPECT_EQ(arena.body().doing, Doing::kicking);
    EXPECT_EQ(arena.body().kind, 0);
    EXPECT_TRUE(arena.body().kick_left);
    EXPECT_EQ(arena.body().since, begun.since);
    EXPECT_EQ(arena.body().position, begun.position);
    EXPECT_EQ(arena.body().velocity, Vec2{});
  }
}

TEST(Kick, IsFollowedByAWalkWithoutDelay) {
  for (const bool waits : {false, true}) {
    Arena arena{.effects = no_noise()};
    arena.move(kick_command(0, true), ticks(arena.model.kicks[0].duration));
    if (waits) arena.move({}, ticks(arena.model.walk.stop_delay) + 1);
    EXPECT_EQ(arena.body().doing, waits ? Doing::standing : Doing::stopping);
    arena.move(walk_speed({0.2f, 0}, 0));
    EXPECT_EQ(arena.body().doing, waits ? Doing::starting : Doing::walking);
    EXPECT_EQ(arena.body().position.x > 0, !waits);
  }
}

TEST(Kick, ManyTicksAtOnceEqualManySingleTicks) {
  for (Tick steps = 1; steps < 70; ++steps) {
    Arena once{.effects = all_effects()};
    once.world.ball.position = {0.185f, 0.05f};
    Arena often = once;
    once.move(kick_command(0, true), steps);
    for (Tick tick = 0; tick < steps; ++tick) often.move(tick == 0 ? kick_command(0, true) : Command{});
    ASSERT_EQ(once.body().doing, often.body().doing) << steps;
    ASSERT_EQ(once.body().since, often.body().since);
    ASSERT_EQ(once.world.ball.velocity, often.world.ball.velocity);
  }
}

TEST(Kick, DoesNotBeginWithAnUnknownIndex) {
  Arena arena;
  arena.move(kick_command(3, true), 10);
  EXPECT_EQ(arena.body().doing, Doing::standing);
}

TEST(Kick, TwoInOneTickAddUpInAnyOrder) {
  const auto both = [](int first, int second) {
    Arena arena{.effects = no_noise()};
    World& world = arena.world;
    // two robots face each other, the ball between them at both left feet; one kicks less
    world.ball.position = {0, 0};
    world.bodies[0].position = {-0.185f, -0.05f};
    world.bodies[7].position = {0.185f, 0.05f};
    world.bodies[7].heading = kPi;
    world.bodies[7].facing = {-1, 0};
    Command commands[2] = {kick_command(0, true), kick_command(0, true)};
    commands[1].gain = 0.5f;
    const int robots[2] = {0, 7};
    const Tick delay = ticks(arena.model.kicks[0].delay) + 1;
    for (Tick tick = 0; tick < delay; ++tick, ++world.tick) {
      for (const int i : {first, second}) {
        const Mover mover{&commands[i], nullptr, &world, robots[i], 1, 0};
        motion::move({arena.model, arena.effects, arena.ball}, {&mover, 1});
      }
    }
    return world;
  };
  const World one = both(0, 1);
  const World other = both(1, 0);
  EXPECT_EQ(one.ball.velocity, other.ball.velocity);
  EXPECT_GT(one.ball.velocity.x, 0);
  EXPECT_EQ(one.kicked, other.kicked);
  EXPECT_NE(one.kicked, kNobody);
}

TEST(Kick, AMirroredKickIsTheMirrorImageToTheBit) {
  for (int kick = 0; kick < 3; ++kick) {
    Arena left{.effects = no_noise()};
    left.body().heading = 0.7f;
    left.body().facing = direction(0.7f);
    left.world.ball.position = turned({0.19f, 0.07f}, left.body().facing);
    Arena right = left;
    right.body().heading = -0.7f;
    right.body().facing = direction(-0.7f);
    right.world.ball.position.y = -left.world.ball.position.y;
    left.move(kick_command(kick, true), 50);
    right.move(kick_command(kick, false), 50);
    EXPECT_EQ(left.world.ball.velocity, (Vec2{right.world.ball.velocity.x, -right.world.ball.velocity.y}));
    EXPECT_EQ(left.world.kicked, right.world.kicked);
  }
}

TEST(Kick, IsFoundByItsName) {
  const Model model = match_model();
  EXPECT_EQ(find_kick(model, "forward"), 0);
  EXPECT_EQ(find_kick(model, "turn"), 2);
  EXPECT_EQ(find_kick(model, "turns"), -1);
  EXPECT_EQ(find_kick(model, ""), -1);
}

}  // namespace
}  // namespace sim::motion
