#include "robot/app/truth/simulated_scene.h"

#include <gtest/gtest.h>

#include <cmath>

namespace robot::app {
namespace {

sim::World world_of_two() {
  sim::World world;
  world.players = 1;
  world.ball.position = {1, -2};
  world.bodies[0].position = {0.5f, 0.25f};
  world.bodies[0].heading = 1;
  world.bodies[sim::kMaxPlayers].position = {-1, 0};
  return world;
}

TEST(SimulatedScene, ThingsStandWhereTheWorldHasThem) {
  const truth::Scene scene = scene_of(world_of_two(), 0.05, 6);
  ASSERT_EQ(scene.robots.size(), 2u);
  EXPECT_EQ(scene.robots[0].x, 0.5);
  EXPECT_EQ(scene.robots[0].heading, 1);
  ASSERT_TRUE(scene.ball);
  EXPECT_EQ(scene.ball->y, -2);
  EXPECT_EQ(scene.ball->z, 0.05);
}

TEST(SimulatedScene, RemovedRobotsAreNotThereAndFallenOnesLie) {
  sim::World world = world_of_two();
  world.bodies[0].doing = sim::Body::Doing::removed;
  world.bodies[sim::kMaxPlayers].doing = sim::Body::Doing::getting_up;
  const truth::Scene scene = scene_of(world, 0.05, 6);
  ASSERT_EQ(scene.robots.size(), 1u);
  EXPECT_TRUE(scene.robots[0].fallen);
}

TEST(SimulatedScene, TheRefereeWalksBesideTheFieldWithoutALeap) {
  sim::World world = world_of_two();
  double last = scene_of(world, 0.05, 6).people.at(0).x;
  for (world.tick = 1; world.tick < 1000; ++world.tick) {
    const truth::ScenePerson person = scene_of(world, 0.05, 6).people.at(0);
    EXPECT_GT(person.y, 3);
    EXPECT_LE(std::abs(person.x), 2.001);
    EXPECT_LT(std::abs(person.x - last), 0.03);
    last = person.x;
  }
}

}  // namespace
}  // namespace robot::app
