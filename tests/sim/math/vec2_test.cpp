#include "sim/math/vec2.h"

#include <gtest/gtest.h>

#include <random>

namespace {

using sim::Vec2;

/// Calls see(a, facing) for points and unit vectors of all directions.
template <class See>
void for_many(See&& see) {
  std::mt19937 random(1);
  std::uniform_real_distribution<float> metres(-5, 5), radians(-sim::kPi, sim::kPi);
  for (int i = 0; i < 10000; ++i) {
    const Vec2 a{metres(random), metres(random)};
    see(a, sim::direction(radians(random)));
  }
}

TEST(Vec2, TurnedBackUndoesTurned) {
  for_many([](Vec2 a, Vec2 facing) {
    EXPECT_LT(sim::distance(sim::turned_back(sim::turned(a, facing), facing), a), 2e-6f);
  });
}

TEST(Vec2, TurningKeepsLengthsAndAddsAngles) {
  for_many([](Vec2 a, Vec2 facing) {
    const Vec2 b = sim::turned(a, facing);
    EXPECT_NEAR(sim::length(b), sim::length(a), 2e-6f);
    EXPECT_NEAR(sim::normalized(sim::angle_of(b) - sim::angle_of(a) - sim::angle_of(facing)), 0, 2e-6f);
  });
}

TEST(Vec2, DirectionAndAngleAreInverse) {
  for_many([](Vec2 a, Vec2) { EXPECT_LT(sim::distance(sim::length(a) * sim::direction(sim::angle_of(a)), a), 4e-6f); });
}

TEST(Vec2, DirectionOfSmallIsTheSameToTheBit) {
  for (int i = -4000; i <= 4000; ++i) {
    const float angle = static_cast<float>(i) * 0.0005f;
    EXPECT_EQ(sim::direction_of_small(angle), sim::direction(angle)) << angle;
  }
}

TEST(Vec2, TheMirrorImageOfATurnIsTheTurnOfTheMirrorImages) {
  const auto mirrored = [](Vec2 a) { return Vec2{a.x, -a.y}; };
  for_many([&](Vec2 a, Vec2 facing) {
    EXPECT_EQ(sim::turned(mirrored(a), mirrored(facing)), mirrored(sim::turned(a, facing)));
    EXPECT_EQ(sim::turned_back(mirrored(a), mirrored(facing)), mirrored(sim::turned_back(a, facing)));
    EXPECT_EQ(sim::cross(mirrored(a), mirrored(facing)), -sim::cross(a, facing));
  });
}

}  // namespace
