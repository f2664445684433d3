#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "tests/sim/world/arena.h"

namespace {

using namespace sim;
using namespace sim::arena;

void bounce(World& world, const Effects& effects = kIdeal) {
  bounce_ball(kField, kBall, kContact, effects, crowd_of(world), world);
}

/// Plays one tick of the ball.
void roll_and_bounce(World& world, const Effects& effects = kIdeal) {
  roll(world.ball, kBall.deceleration, kBall.stop_speed, kTickDuration);
  bounce(world, effects);
  ++world.tick;
}

/// Returns the distance from the ball to the nearest robot on the field [m].
float gap_to_robots(const World& world) {
  float gap = 1e6f;
  for (const Body& body : world.bodies)
    if (on_field(body)) gap = std::min(gap, distance(body.position, world.ball.position));
  return gap;
}

/// Robots in a square of 2 m and a ball that flies at them.
World shot_at_crowd(std::mt19937& random, bool standing) {
  World world = crowd(random, {0, 0}, 2);
  std::uniform_real_distribution<float> radians(-kPi, kPi), speed(0.1f, 3), offset(-0.7f, 0.7f);
  const float angle = radians(random), fast = speed(random), aside = offset(random);
  world.ball.position = turned({-1.8f, aside}, direction(angle));
  world.ball.velocity = fast * direction(angle);
  for (Body& body : world.bodies)
    if (standing) body.velocity = {};
  return world;
}

TEST(Bounce, AStandingBodyThrowsTheBallBack) {
  for (float heading = -3; heading < 3; heading += 0.1f) {
    World world = empty();
    stand(world, 4, {2, 1}, 1.f);
    const Vec2 way = direction(heading);
    world.ball.position = Vec2{2, 1} - (kReach + 0.05f) * way;
    world.ball.velocity = 2 * way;
    roll_and_bounce(world);
    const float before = 2 - 0.3f * kTickDuration;
    EXPECT_NEAR(distance(world.ball.velocity, -0.4f * before * way), 0, 1e-4);
    EXPECT_GE(distance(world.ball.position, {2, 1}), kReach);
    EXPECT_EQ(world.touched, 4);
  }
}

TEST(Bounce, AGrazingBallKeepsItsTangentialSpeed) {
  World world = empty();
  stand(world, 4, {2, 0});
  const Vec2 before{1.5f, 0};
  world.ball.position = {2 - 0.09f, 0.1f};
  world.ball.velocity = before;
  bounce(world);
  EXPECT_EQ(world.touched, 4);

  // only the speed towards the body changed: the change points from the body's middle to the contact
  const Vec2 change = world.ball.velocity - before;
  const Vec2 away = (1 / length(change)) * change;
  EXPECT_NEAR(kReach * away.y, 0.1f, 1e-4);
  EXPECT_NEAR(cross(away, world.ball.velocity), cross(away, before), 1e-4);
  EXPECT_NEAR(dot(away, world.ball.velocity), -0.4f * dot(away, before), 1e-4);
}

TEST(Bounce, APostThrowsTheBallBackAndTouchesNothing) {
  for (int post = 0; post < field::kPosts; ++post) {
    World world = empty();
    const Vec2 position = field::post_of(kField, post);
    const Vec2 way = (1 / length(position)) * position;
    world.ball.position = position - 0.15f * way;
    world.ball.velocity = 3 * way;
    roll_and_bounce(world);
    EXPECT_NEAR(dot(world.ball.velocity, way), -0.4f * (3 - 0.3f * kTickDuration), 1e-4);
    EXPECT_EQ(world.touched, kNobody);
  }
}

TEST(Bounce, AStandingThingNeverMakesTheBallFaster) {
  std::mt19937 random(1);
  int touches = 0;
  for (int i = 0; i < 1500; ++i) {
    World world = shot_at_crowd(random, true);
    for (int tick = 0; tick < 60; ++tick) {
      const float speed = length(world.ball.velocity);
      world.touched = kNobody;
      roll_and_bounce(world, kNoisyPush);
      EXPECT_LE(length(world.ball.velocity), speed * 1.000001f);
      touches += world.touched != kNobody;
    }
  }
  EXPECT_GT(touches, 1000);
}

TEST(Bounce, TheFastestBallPassesThroughNothing) {
  std::mt19937 random(1);
  int bounced = 0;
  for (int i = 0; i < 20000; ++i) {
    // a body or a post, and a ball whose straight way through this tick leads to or through it
    World world = empty();
    const bool post = i % 2 == 0;
    const Vec2 middle = post ? field::post_of(kField, i / 2 % field::kPosts) : Vec2{1, 1};
    if (!post) stand(world, 4, middle);
    const float reach = (post ? kField.post_radius : kContact.foot_radius) + kBall.radius;
    std::uniform_real_distribution<float> radians(-kPi, kPi), speed(0.2f, 12), aside(-0.95f, 0.95f), share(0, 1);
    const Vec2 way = direction(radians(random));
    const float fast = speed(random), offset = reach * aside(random);
    const float entry = -std::sqrt(reach * reach - offset * offset);
    const Vec2 start = middle + turned({entry - share(random) * fast * kTickDuration, offset}, way);
    world.ball.position = start;
    world.ball.velocity = fast * way;
    roll(world.ball, kBall.deceleration, kBall.stop_speed, kTickDuration);
    const Vec2 through = world.ball.position;
    bounce(world);

    // the ball is outside and does not move inwards
    EXPECT_GE(distance(world.ball.position, middle), reach - 0.0005f);
    const bool entered = dot(through - start, way) + dot(start - middle, way) > entry + 0.001f;
    if (!entered) continue;
    ++bounced;
    EXPECT_GT(dot(world.ball.velocity, world.ball.position - middle), -1e-4f);
    EXPECT_LT(dot(world.ball.velocity, way), fast);
    EXPECT_EQ(world.touched, post ? kNobody : 4);
  }
  EXPECT_GT(bounced, 15000);
}

TEST(Bounce, AWalkingBodyPushesTheBallAlongAtLeastAsFast) {
  for (const Effects& effects : {kIdeal, kNoisyPush})
    for (std::uint64_t seed = 0; seed < 300; ++seed) {
      World world = empty();
      world.key = {seed};
      Body& body = walk(world, 2, {0, 0}, 0.7f, {0.25f, 0});
      world.ball.position = (kReach - 0.005f) * body.facing;
      bounce(world, effects);
      EXPECT_GE(dot(world.ball.velocity, body.facing), 0.25f - 1e-5f);
      EXPECT_GE(distance(world.ball.position, body.position), kReach - 1e-5f);
      EXPECT_EQ(world.touched, 2);
    }
}

TEST(Bounce, AWalkingRobotDribblesTheBallInFrontOfIt) {
  for (std::uint64_t seed = 0; seed < 50; ++seed) {
    World world = empty();
    world.key = {seed};
    Body& body = walk(world, 2, {-3, 0}, 0, {0.25f, 0});
    world.ball.position = {-2.8f, 0};
    for (int tick = 0; tick < 600; ++tick) {
      body.position.x += 0.25f * kTickDuration;
      roll_and_bounce(world);
      EXPECT_GE(distance(world.ball.position, body.position), kReach - 1e-4f);
      EXPECT_LE(length(world.ball.velocity), 0.25f * 1.41f);
    }
    EXPECT_GT(world.ball.position.x, body.position.x);
  }
}

TEST(Bounce, PushNoiseChangesTheDirectionOnly) {
  double sum = 0, squares = 0;
  constexpr int kCount = 4000;
  for (int i = 0; i < kCount; ++i) {
    World world = empty();
    world.tick = static_cast<Tick>(i);
    walk(world, 2, {0, 0}, 0, {0.25f, 0});
    world.ball.position = {kReach, 0};
    world.ball.velocity = {-1, 0};
    bounce(world, kNoisyPush);
    const float angle = angle_of(world.ball.velocity);
    sum += angle;
    squares += angle * angle;
  }
  EXPECT_NEAR(sum / kCount, 0, 0.03);
  EXPECT_NEAR(std::sqrt(squares / kCount), kContact.push_deviation, 0.03);
}

TEST(Bounce, ABallPushedFromBothSidesStays) {
  World world = empty();
  walk(world, 2, {-kReach + 0.005f, 1}, 0, {0.25f, 0});
  walk(world, 9, {kReach - 0.005f, 1}, kPi, {0.25f, 0});
  world.ball.position = {0, 1};
  bounce(world);
  EXPECT_NEAR(length(world.ball.velocity), 0, 1e-6);
  EXPECT_NEAR(distance(world.ball.position, {0, 1}), 0, 1e-6);
}

TEST(Bounce, OfTwoAtOnceHomeIsTheToucherInEvenTicksAndAwayInOddOnes) {
  for (const Tick tick : {4u, 5u}) {
    World world = empty();
    world.tick = tick;
    stand(world, 2, {-kReach + 0.005f, 1});
    stand(world, 9, {kReach - 0.005f, 1});
    world.ball.position = {0, 1};
    bounce(world);
    EXPECT_EQ(world.touched, tick % 2 == 0 ? 2 : 9);
  }
}

TEST(Bounce, FarFromEverythingNothingChanges) {
  std::mt19937 random(3);
  for (int i = 0; i < 1000; ++i) {
    World world = shot_at_crowd(random, false);
    world.ball.position = turned({-3, 0}, direction(static_cast<float>(i)));
    const World before = world;
    bounce(world);
    EXPECT_EQ(world.ball.position, before.ball.position);
    EXPECT_EQ(world.ball.velocity, before.ball.velocity);
    EXPECT_EQ(world.touched, kNobody);
  }
}

TEST(Bounce, ADuelSqueezesTheBallOutSidewaysAsOftenAsTheModelSays) {
  ContactModel contact = kContact;
  contact.duel_gap = 0.05f;
  contact.duel_rate = 3;
  contact.duel_speed = 1;
  int squeezed = 0, left = 0;
  constexpr int kCount = 10000;
  for (int i = 0; i < kCount; ++i)
    for (const bool duels : {false, true}) {
      World world = empty();
      world.tick = static_cast<Tick>(i);
      walk(world, 2, {-kReach - 0.02f, 0}, 0, {0.25f, 0});
      walk(world, 9, {kReach + 0.02f, 0}, kPi, {0.25f, 0});
      bounce_ball(kField, kBall, contact, Effects{.duels = duels}, crowd_of(world), world);
      if (world.ball.velocity == Vec2{}) continue;
      ASSERT_TRUE(duels);
      EXPECT_NEAR(world.ball.velocity.x, 0, 1e-5f);
      EXPECT_LE(length(world.ball.velocity), 1);
      ++squeezed;
      left += world.ball.velocity.y > 0 ? 1 : 0;
    }
  EXPECT_NEAR(squeezed, kCount / 10, 120);
  EXPECT_NEAR(left, squeezed / 2, 70);
}

TEST(Bounce, ARemovedRobotTouchesNothing) {
  World world = empty();
  stand(world, 0, {0.1f, 0}).doing = Body::Doing::removed;
  bounce(world);
  EXPECT_EQ(world.ball.position, Vec2{});
  EXPECT_EQ(world.touched, kNobody);
}

TEST(Bounce, AFallenRobotIsLarger) {
  World world = empty();
  stand(world, 0, {0.2f, 0}).doing = Body::Doing::fallen;
  bounce(world);
  EXPECT_NEAR(gap_to_robots(world), kContact.lying_radius + kBall.radius, 1e-5);
}

TEST(Bounce, ASquattingRobotIsWiderOnceItIsDown) {
  for (const auto& [doing, radius] : {std::pair{Body::Doing::crouching, kContact.foot_radius},
                                      std::pair{Body::Doing::squatting, kContact.squatting_radius}}) {
    World world = empty();
    stand(world, 0, {0.1f, 0}).doing = doing;
    bounce(world);
    EXPECT_NEAR(gap_to_robots(world), radius + kBall.radius, 1e-5);
  }
}

TEST(Bounce, DoesNotDependOnTheOrderOfRobots) {
  std::mt19937 random(4);
  int touches = 0;
  for (int i = 0; i < 1000; ++i) {
    World world = shot_at_crowd(random, false);
    int order[kMaxRobots];
    shuffle(random, order);
    World other = reordered(world, order);
    for (int tick = 0; tick < 40; ++tick) {
      world.touched = other.touched = kNobody;
      roll_and_bounce(world);
      roll_and_bounce(other);
      ASSERT_EQ(world.ball.position, other.ball.position);
      ASSERT_EQ(world.ball.velocity, other.ball.velocity);
      ASSERT_EQ(world.touched == kNobody, other.touched == kNobody);
      if (world.touched == kNobody) continue;
      ASSERT_EQ(order[other.touched], world.touched);
      ++touches;
    }
  }
  EXPECT_GT(touches, 500);
}

TEST(Bounce, AMirroredBallBouncesTheMirroredWay) {
  std::mt19937 random(5);
  for (int i = 0; i < 1000; ++i) {
    World world = shot_at_crowd(random, false);
    World other = mirrored(world);
    for (int tick = 0; tick < 40; ++tick) {
      roll_and_bounce(world);
      roll_and_bounce(other);
      ASSERT_EQ(other.ball.position, mirrored(world.ball.position));
      ASSERT_EQ(other.ball.velocity, mirrored(world.ball.velocity));
      ASSERT_EQ(other.touched, world.touched);
    }
  }
}

}  // namespace
