// Tests of the squat.
#include <gtest/gtest.h>

#include "tests/sim/motion/arena.h"

namespace sim::motion {
namespace {

using Doing = Body::Doing;

const Command kSquat{.body = Command::Body::squat};
const Command kWalk{.body = Command::Body::walk_speed, .walk = {0.25f, 0}};

Arena keeper() {
  Arena arena;
  arena.model.squat = {.delay = 0.3f, .duration = 2};
  return arena;
}

TEST(Squat, IsDownAfterItsDelayAndUpAfterItsDuration) {
  Arena arena = keeper();
  for (Tick tick = 0; tick < ticks(2); ++tick) {
    arena.move(kSquat);
    const Tick elapsed = tick + 1;
    const Doing expected = elapsed < ticks(0.3f) ? Doing::crouching
                           : elapsed < ticks(2)  ? Doing::squatting
                                                 : Doing::standing;
    ASSERT_EQ(arena.body().doing, expected) << "after " << elapsed << " ticks";
  }
}

TEST(Squat, StopsTheBodyAndIsNotInterrupted) {
  Arena arena = keeper();
  for (int tick = 0; tick < 60; ++tick) arena.move(kWalk);
  ASSERT_GT(arena.body().velocity.x, 0);

  while (arena.body().doing == Doing::walking) arena.move(kSquat);
  const Vec2 place = arena.body().position;
  const Command kick{.body = Command::Body::kick};
  for (Tick tick = 1; tick + 1 < ticks(2); ++tick) {
    arena.move(tick % 2 == 0 ? kWalk : kick);
    ASSERT_TRUE(arena.body().doing == Doing::crouching || arena.body().doing == Doing::squatting);
    ASSERT_EQ(arena.body().position, place);
  }
}

TEST(Squat, ManyTicksAtOnceEqualManySingleTicks) {
  for (Tick steps = 1; steps <= 70; ++steps) {
    Arena once = keeper(), singly = keeper();
    once.move(kSquat);
    singly.move(kSquat);
    once.move(Command{}, steps);
    for (Tick tick = 0; tick < steps; ++tick) singly.move(Command{});
    EXPECT_EQ(once.body().doing, singly.body().doing) << steps;
    EXPECT_EQ(once.body().position, singly.body().position) << steps;
  }
}

}  // namespace
}  // namespace sim::motion
