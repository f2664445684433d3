// Tests of falls.
#include <gtest/gtest.h>

#include "tests/sim/motion/arena.h"

namespace sim::motion {
namespace {

using Doing = Body::Doing;

Arena with_falls(std::uint64_t seed) {
  Arena arena{.effects = all_effects()};
  arena.effects.falls = true;
  arena.world.key.seed = seed;
  return arena;
}

// share of bodies that fall within `duration` [s] with this command
float share_fallen(const Command& command, bool touching, bool effect, int duration) {
  int fallen = 0;
  const int count = 1000;
  for (int seed = 0; seed < count; ++seed) {
    Arena arena = with_falls(static_cast<std::uint64_t>(seed));
    arena.effects.falls = effect;
    arena.effects.walk_delay = false;
    arena.body().touching = touching ? 10 : 0;
    for (int tick = 0; tick < 30 * duration && arena.body().doing != Doing::fallen; ++tick) arena.move(command);
    fallen += arena.body().doing == Doing::fallen ? 1 : 0;
  }
  return static_cast<float>(fallen) / static_cast<float>(count);
}

TEST(Fall, HappensAsOftenAsTheModelSays) {
  // 6 a minute walking, 0.5 a second touching: 1 - exp(-rate * duration)
  const Command walk = walk_speed({0.2f, 0}, 0);
  EXPECT_NEAR(share_fallen(walk, false, true, 5), 0.393f, 0.05f);
  EXPECT_NEAR(share_fallen({}, true, true, 1), 0.393f, 0.05f);
  EXPECT_NEAR(share_fallen(walk, true, true, 1), 0.451f, 0.05f);
  EXPECT_EQ(share_fallen({}, false, true, 5), 0) << "a robot that stands alone does not fall";
  EXPECT_EQ(share_fallen(walk, true, false, 5), 0) << "no body falls without the effect";
}

TEST(Fall, LiesGetsUpAndStandsDespiteCommands) {
  int repeated = 0;
  const int count = 2000;
  for (int seed = 0; seed < count; ++seed) {
    Arena arena = with_falls(static_cast<std::uint64_t>(seed));
    arena.model.falls.per_minute_walking = 0;
    arena.body().doing = Doing::fallen;
    Command command = walk_speed({0.2f, 0}, 1);
    command.head = Command::Head::angles;
    command.look[0] = 1;
    for (const auto& [doing, duration] : {std::pair{Doing::fallen, 1.f}, std::pair{Doing::getting_up, 2.f}}) {
      for (Tick tick = 0; tick < ticks(duration); ++tick) {
        ASSERT_EQ(arena.body().doing, doing);
        ASSERT_EQ(arena.body().head_yaw, 0);
        arena.move(command);
      }
      command.body = Command::Body::kick;
    }
    // either up, or down again
    const bool failed = arena.body().doing == Doing::fallen;
    repeated += failed ? 1 : 0;
    ASSERT_TRUE(failed || arena.body().doing == Doing::standing);
    EXPECT_EQ(arena.body().position, Vec2{});
    EXPECT_EQ(arena.body().since, ticks(3));
  }
  EXPECT_NEAR(static_cast<float>(repeated) / count, match_model().falls.failure, 0.04f);
}

TEST(Fall, EndsWhatTheBodyWasDoing) {
  for (std::uint64_t seed = 0; seed < 50; ++seed) {
    Arena arena = with_falls(seed);
    arena.body().touching = 1;
    arena.model.falls.per_second_touching = 10;
    Command kick;
    kick.body = Command::Body::kick;
    arena.move(kick);
    for (int tick = 0; tick < 40 && arena.body().doing == Doing::kicking; ++tick) arena.move(kick);
    EXPECT_EQ(arena.body().doing, Doing::fallen);
    EXPECT_EQ(arena.body().velocity, Vec2{});
  }
}

TEST(Fall, ManyTicksAtOnceEqualManySingleTicks) {
  for (Tick steps = 1; steps < 200; steps += 7) {
    Arena once = with_falls(steps);
    once.model.falls.per_minute_walking = 0;
    once.body().doing = Doing::fallen;
    Arena often = once;
    once.move({}, steps);
    for (Tick tick = 0; tick < steps; ++tick) often.move({});
    EXPECT_EQ(once.body().doing, often.body().doing);
    EXPECT_EQ(once.body().since, often.body().since);
  }
}

}  // namespace
}  // namespace sim::motion
