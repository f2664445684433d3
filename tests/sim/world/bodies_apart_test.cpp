#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "tests/sim/world/arena.h"

namespace {

using namespace sim;
using namespace sim::arena;

void part(World& world) {
  Crowd crowd = crowd_of(world);
  keep_bodies_apart(kField, kContact, crowd, world);
  for (int i = 0; i < crowd.count; ++i) {
    const Body& body = world.bodies[crowd.robot(i)];
    if (on_field(body)) {
      EXPECT_EQ(crowd.middle(i), body.position);
    }
  }
}

float radius_of(const Body& body) { return lies(body) ? kContact.lying_radius : kContact.robot_radius; }

/// Returns the deepest overlap on the field [m].
float overlap_in(const World& world) {
  float worst = 0;
  for (int i = 0; i < kMaxRobots; ++i) {
    const Body& body = world.bodies[i];
    if (!on_field(body)) continue;
    for (int j = i + 1; j < kMaxRobots; ++j) {
      const Body& other = world.bodies[j];
      if (!on_field(other)) continue;
      worst = std::max(worst, radius_of(body) + radius_of(other) - distance(body.position, other.position));
    }
    for (int post = 0; post < field::kPosts; ++post)
      worst =
          std::max(worst, radius_of(body) + kField.post_radius - distance(body.position, field::post_of(kField, post)));
    worst =
        std::max(worst, radius_of(body) + kContact.official_radius - distance(body.position, world.official.position));
  }
  return worst;
}

/// Calls see(world) for heaps of robots, thin and thick, on the field and round a post.
template <class See>
void for_many_heaps(See&& see) {
  std::mt19937 random(1);
  for (int i = 0; i < 600; ++i) {
    const float size = 0.02f * static_cast<float>(1 << (i % 8));
    World world = crowd(random, i % 3 == 0 ? field::post_of(kField, i % field::kPosts) : Vec2{1, 2}, size);
    if (i % 5 == 0) world.official.position = world.bodies[3].position + Vec2{0.1f, 0.2f};
    see(world, random);
  }
}

TEST(BodiesApart, NoTwoOverlapByMoreThanAMillimetreNorOneAPost) {
  int overlapping = 0;
  for_many_heaps([&](World world, std::mt19937&) {
    overlapping += overlap_in(world) > 0.001f;
    part(world);
    EXPECT_LE(overlap_in(world), 0.001f);
  });
  EXPECT_GT(overlapping, 400);
}

TEST(BodiesApart, PartsAllRobotsFromOnePlaceAtAPost) {
  for (int post = 0; post < field::kPosts; ++post) {
    World world = empty();
    for_each_robot(7, [&](int robot) { stand(world, robot, field::post_of(kField, post)); });
    part(world);
    EXPECT_LE(overlap_in(world), 0.001f);
  }
}

TEST(BodiesApart, EachRobotGoesHalfOfTheWay) {
  World world = empty();
  stand(world, 0, {1, 1});
  stand(world, 8, {1.2f, 1.1f});
  const Vec2 sum = world.bodies[0].position + world.bodies[8].position;
  part(world);
  EXPECT_NEAR(distance(world.bodies[0].position, world.bodies[8].position), 0.32f, 1e-5);
  EXPECT_NEAR(distance(world.bodies[0].position + world.bodies[8].position, sum), 0, 1e-5);
}

TEST(BodiesApart, ARobotWithoutOverlapStaysToTheBit) {
  std::mt19937 random(2);
  for (int i = 0; i < 300; ++i) {
    World world = crowd(random, {0, 0}, 6);
    const World before = world;
    part(world);
    for (int robot = 0; robot < kMaxRobots; ++robot) {
      const Body &body = before.bodies[robot], &after = world.bodies[robot];
      float gap = 1e6f;
      for (int other = 0; other < kMaxRobots; ++other)
        if (other != robot && on_field(before.bodies[other]))
          gap = std::min(gap, distance(before.bodies[other].position, body.position));
      if (!on_field(body) || gap > 1.5f) {
        EXPECT_EQ(body.position, after.position);
      }
    }
  }
}

TEST(BodiesApart, ASecondCallChangesNothing) {
  for_many_heaps([](World world, std::mt19937&) {
    part(world);
    const World once = world;
    part(world);
    for (int robot = 0; robot < kMaxRobots; ++robot)
      EXPECT_EQ(world.bodies[robot].position, once.bodies[robot].position);
  });
}

TEST(BodiesApart, DoesNotDependOnTheOrderOfRobots) {
  for_many_heaps([](World world, std::mt19937& random) {
    int order[kMaxRobots];
    shuffle(random, order);
    World other = reordered(world, order);
    part(world);
    part(other);
    const World expected = reordered(world, order);
    for (int robot = 0; robot < kMaxRobots; ++robot) {
      EXPECT_EQ(other.bodies[robot].position, expected.bodies[robot].position);
      EXPECT_EQ(other.bodies[robot].touching, expected.bodies[robot].touching);
      EXPECT_EQ(other.bodies[robot].pushing, expected.bodies[robot].pushing);
    }
  });
}

TEST(BodiesApart, MirroredRobotsPartTheMirroredWay) {
  for_many_heaps([](World world, std::mt19937&) {
    World other = mirrored(world);
    part(world);
    part(other);
    for (int robot = 0; robot < kMaxRobots; ++robot) {
      EXPECT_EQ(other.bodies[robot].position, mirrored(world.bodies[robot].position));
      EXPECT_EQ(other.bodies[robot].touching, world.bodies[robot].touching);
      EXPECT_EQ(other.bodies[robot].pushing, world.bodies[robot].pushing);
    }
  });
}

constexpr float kTouch = 0.01f;         // [m] gap below which bodies touch
constexpr float kUndecided = 0.00001f;  // [m] from that gap, rounding decides

/// Returns the gap between a body and another one on the field [m].
float gap_between(const World& world, int robot, int other) {
  const Body &first = world.bodies[robot], &second = world.bodies[other];
  if (robot == other || !on_field(first) || !on_field(second)) return 1e6f;
  return distance(first.position, second.position) - radius_of(first) - radius_of(second);
}

TEST(BodiesApart, CountsTheTouchesThatATestOfAllPairsFinds) {
  int touching = 0, free = 0;
  const auto check = [&](World world, std::mt19937&) {
    const World before = world;
    part(world);
    for_each_robot(world.players, [&](int robot) {
      float gap = 1e6f;
      for_each_robot(world.players, [&](int other) { gap = std::min(gap, gap_between(before, robot, other)); });
      if (std::abs(gap - kTouch) < kUndecided) return;
      EXPECT_EQ(world.bodies[robot].touching, gap < kTouch ? 1 : 0) << robot;
      EXPECT_TRUE(world.crowded || gap >= kTouch);
      ++(gap < kTouch ? touching : free);
    });
  };
  for_many_heaps(check);
  std::mt19937 random(3);
  for (int i = 0; i < 300; ++i) check(crowd(random, {0, 0}, 6), random);
  EXPECT_GT(touching, 1000);
  EXPECT_GT(free, 1000);
}

TEST(BodiesApart, ARobotAtAPostOrAtTheRefereeCrowdsTheWorldAndAFreeOneDoesNot) {
  const Vec2 post = field::post_of(kField, 2);
  const auto crowds = [](Vec2 robot, Vec2 official) {
    World world = empty();
    stand(world, 12, robot);
    world.official.position = official;
    part(world);
    EXPECT_EQ(world.bodies[12].touching, 0);
    return world.crowded;
  };
  const float at_post = kContact.robot_radius + kField.post_radius + kTouch;
  const float at_official = kContact.robot_radius + kContact.official_radius + kTouch;
  const Vec2 nowhere = Official{}.position;
  for (float angle = -3; angle < 3; angle += 0.1f) {
    EXPECT_TRUE(crowds(post + (at_post - 0.001f) * direction(angle), nowhere));
    EXPECT_FALSE(crowds(post + (at_post + 0.001f) * direction(angle), nowhere));
    EXPECT_TRUE(crowds({1, 1}, Vec2{1, 1} + (at_official - 0.001f) * direction(angle)));
    EXPECT_FALSE(crowds({1, 1}, Vec2{1, 1} + (at_official + 0.001f) * direction(angle)));
  }
}

TEST(BodiesApart, ARemovedRobotTouchesNothing) {
  World world = empty();
  stand(world, 0, {1, 1});
  stand(world, 1, {1.1f, 1}).doing = Body::Doing::removed;
  part(world);
  EXPECT_EQ(world.bodies[0].position, (Vec2{1, 1}));
  EXPECT_EQ(world.bodies[1].position, (Vec2{1.1f, 1}));
  EXPECT_EQ(world.bodies[0].touching, 0);
}

TEST(BodiesApart, RobotsGiveWayToTheWalkingReferee) {
  World world = empty();
  stand(world, 0, {1, 1});
  world.official.position = {1.2f, 1};
  part(world);
  EXPECT_EQ(world.official.position, (Vec2{1.2f, 1}));
  EXPECT_NEAR(distance(world.bodies[0].position, world.official.position), 0.36f, 1e-5);
  EXPECT_EQ(world.bodies[0].touching, 0) << "only robots count";
}

/// One robot walks at another for `ticks`, the other stands.
World run_into(int ticks, Vec2 velocity) {
  World world = empty();
  walk(world, 0, {0, 0}, 0.5f, velocity);
  stand(world, 9, 0.319f * direction(0.5f));
  for (int i = 0; i < ticks; ++i, ++world.tick) {
    Body& body = world.bodies[0];
    body.position += kTickDuration * turned(body.velocity, body.facing);
    part(world);
  }
  return world;
}

TEST(BodiesApart, CountTouchingInTicksAndPushingInFifthsOfASecond) {
  const World world = run_into(60, {0.2f, 0});
  EXPECT_EQ(world.bodies[0].touching, 60);
  EXPECT_EQ(world.bodies[9].touching, 60);
  EXPECT_EQ(world.bodies[0].pushing, 10);
  EXPECT_EQ(world.bodies[9].pushing, 0) << "a standing robot does not push";
  EXPECT_EQ(run_into(300, {0.2f, 0}).bodies[0].touching, 255);
}

TEST(BodiesApart, WalkingPastOrAwayIsNotPushing) {
  for (const Vec2 velocity : {Vec2{-0.0001f, 0}, Vec2{0, 0.0001f}, Vec2{0, 0}}) {
    const World world = run_into(30, velocity);
    EXPECT_EQ(world.bodies[0].touching, 30);
    EXPECT_EQ(world.bodies[0].pushing, 0);
  }
}

TEST(BodiesApart, CountsRestartWithoutContact) {
  World world = run_into(60, {0.2f, 0});
  world.bodies[9].position = {3, 0};
  part(world);
  EXPECT_EQ(world.bodies[0].touching, 0);
  EXPECT_EQ(world.bodies[0].pushing, 0);
  EXPECT_EQ(world.bodies[9].touching, 0);
}

}  // namespace
