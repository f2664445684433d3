#include "sim/world/ball.h"

#include <gtest/gtest.h>

#include <random>

#include "sim/math/tick.h"

namespace {

using sim::Ball;
using sim::Vec2;

constexpr float kDeceleration = 0.3f, kStop = 0.01f;

/// Calls see(ball, random) for many balls of many speeds.
template <class See>
void for_many_balls(See&& see) {
  std::mt19937 random(1);
  std::uniform_real_distribution<float> metres(-4, 4), speed(-3, 3);
  for (int i = 0; i < 2000; ++i) {
    const float x = metres(random), y = metres(random), forward = speed(random), left = speed(random);
    see(Ball{.position = {x, y}, .velocity = {forward, left}}, random);
  }
}

Ball rolled(Ball ball, float dt) {
  sim::roll(ball, kDeceleration, kStop, dt);
  return ball;
}

TEST(Ball, OneLongRollEndsWhereManyShortOnesDo) {
  for_many_balls([](const Ball& ball, std::mt19937& random) {
    std::uniform_real_distribution<float> seconds(0, 3);
    const float first = seconds(random), second = seconds(random);
    const Ball twice = rolled(rolled(ball, first), second), once = rolled(ball, first + second);
    EXPECT_NEAR(sim::distance(twice.position, once.position), 0, 1e-5);
    EXPECT_NEAR(sim::distance(twice.velocity, once.velocity), 0, 1e-5);
  });
}

TEST(Ball, AHundredTicksAreOneLongRoll) {
  for_many_balls([](const Ball& ball, std::mt19937&) {
    Ball stepped = ball;
    for (int tick = 0; tick < 100; ++tick) stepped = rolled(stepped, sim::kTickDuration);
    const Ball once = rolled(ball, 100 * sim::kTickDuration);
    EXPECT_NEAR(sim::distance(stepped.position, once.position), 0, 2e-5);
    EXPECT_NEAR(sim::distance(stepped.velocity, once.velocity), 0, 2e-5);
  });
}

TEST(Ball, StopsAtItsRestingPlace) {
  for_many_balls([](const Ball& ball, std::mt19937&) {
    const Ball lying = rolled(ball, 60);
    EXPECT_EQ(lying.velocity, Vec2{});
    EXPECT_EQ(lying.acceleration, Vec2{});
    EXPECT_NEAR(sim::distance(lying.position, sim::resting_place(ball, kDeceleration)), 0, 0.0002);
  });
}

TEST(Ball, KeepsItsRestingPlaceWhileItRolls) {
  for_many_balls([](const Ball& ball, std::mt19937&) {
    EXPECT_NEAR(
        sim::distance(sim::resting_place(rolled(ball, 0.4f), kDeceleration), sim::resting_place(ball, kDeceleration)),
        0, 0.0002);
  });
}

TEST(Ball, SpeedForRangeRollsThatRange) {
  for (float range = 0; range < 12; range += 0.1f) {
    const Ball ball{.velocity = {sim::speed_for_range(range, kDeceleration), 0}};
    EXPECT_NEAR(sim::resting_place(ball, kDeceleration).x, range, 1e-5);
  }
}

TEST(Ball, RollsStraightAndNeverSpeedsUp) {
  for_many_balls([](const Ball& ball, std::mt19937&) {
    const Ball later = rolled(ball, sim::kTickDuration);
    EXPECT_LE(sim::length(later.velocity), sim::length(ball.velocity));
    EXPECT_GE(sim::dot(later.velocity, ball.velocity), 0);
    EXPECT_NEAR(sim::cross(later.position - ball.position, ball.velocity), 0, 1e-5);
  });
}

TEST(Ball, AccelerationIsTheChangeOfVelocityWhileItRolls) {
  for_many_balls([](const Ball& ball, std::mt19937&) {
    const Ball later = rolled(ball, 0.01f);
    if (later.velocity == Vec2{}) return;
    EXPECT_NEAR(sim::distance(100 * (later.velocity - ball.velocity), later.acceleration), 0, 1e-3);
  });
}

TEST(Ball, RollsForeverWithoutFriction) {
  Ball ball{.velocity = {1, -2}};
  sim::roll(ball, 0, kStop, 10);
  EXPECT_NEAR(sim::distance(ball.position, {10, -20}), 0, 1e-5);
  EXPECT_NEAR(sim::distance(ball.velocity, {1, -2}), 0, 1e-6);
}

TEST(Ball, StopsAtOnceBelowTheStopSpeed) {
  const Ball ball = rolled({.position = {1, 2}, .velocity = {0.006f, -0.006f}}, 0.1f);
  EXPECT_EQ(ball.position, (Vec2{1, 2}));
  EXPECT_EQ(ball.velocity, Vec2{});
}

TEST(Ball, AMirroredBallRollsTheMirroredWay) {
  for_many_balls([](const Ball& ball, std::mt19937&) {
    const auto mirrored = [](Vec2 a) { return Vec2{a.x, -a.y}; };
    const Ball there = rolled(ball, 0.2f);
    const Ball here = rolled({.position = mirrored(ball.position), .velocity = mirrored(ball.velocity)}, 0.2f);
    EXPECT_EQ(here.position, mirrored(there.position));
    EXPECT_EQ(here.velocity, mirrored(there.velocity));
    EXPECT_EQ(here.acceleration, mirrored(there.acceleration));
  });
}

TEST(Ball, RemembersItsPlacesBeforeTheLastRolls) {
  Ball ball{.velocity = {1.5f, 0.5f}};
  Vec2 places[10];
  for (Vec2& place : places) {
    place = ball.position;
    sim::roll(ball, kDeceleration, kStop, sim::kTickDuration);
  }
  for (int i = 0; i < Ball::kPast; ++i) EXPECT_EQ(ball.past[i], places[9 - i]);

  // also when it is at rest
  ball.velocity = {};
  sim::roll(ball, kDeceleration, kStop, sim::kTickDuration);
  sim::roll(ball, kDeceleration, kStop, sim::kTickDuration);
  EXPECT_EQ(ball.past[0], ball.position);
  EXPECT_EQ(ball.past[2], places[9]);
}

TEST(Ball, APlacedBallIsAtRestAndHasNoOtherPast) {
  Ball ball = rolled({.velocity = {2, 1}}, 0.5f);
  sim::place(ball, {1, -2});
  EXPECT_EQ(ball.position, (Vec2{1, -2}));
  EXPECT_EQ(ball.velocity, Vec2{});
  EXPECT_EQ(ball.acceleration, Vec2{});
  for (const Vec2 past : ball.past) EXPECT_EQ(past, ball.position);
}

}  // namespace
