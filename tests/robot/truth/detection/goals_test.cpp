#include "robot/truth/detection/goals.h"

#include <gtest/gtest.h>

#include "tests/robot/truth/detection/watched.h"

namespace robot::truth {
namespace {

SensorPose towards_a_goal() { return looking({-0.5, -3.2, 2.1}, {1.4, 0.2, 0}, kHalf); }

TEST(Goals, AreNoRobots) {
  Watched watched(towards_a_goal());
  for (std::uint64_t number = 0; number < 5; ++number) {
    const Detections seen = watched.see({}, number);
    EXPECT_TRUE(seen.robots.empty());
    EXPECT_FALSE(seen.ball);
  }
}

TEST(Goals, AGoalkeeperBelowTheCrossbarIsSeen) {
  Watched watched(towards_a_goal());
  for (const double y : {-0.3, 0., 0.3}) {
    const Detections seen = watched.see(Scene{.robots = {{.x = 2.97, .y = y, .heading = 3}}});
    ASSERT_EQ(seen.robots.size(), 1U) << y;
    EXPECT_LT(nearest_robot(seen, 2.97, y), 0.05) << y;
  }
}

TEST(Goals, LeaveTheRestOfTheGrid) {
  const SensorPose pose = mast(kField2012, -1, 0, kSmall);
  const Sight sight(pose, kField2012, 0.001, 0.025);
  GroundGrid grid(sight.half_size());
  grid.add(Layer::tall, 3, 0.1F, 0.01F, 0.8F);     // a crossbar
  grid.add(Layer::head, 3, 0.1F, 0.01F, 0.5F);     // a head below it
  grid.add(Layer::body, -3, 0.7F, 0.01F, 0.3F);    // a post
  grid.add(Layer::body, -2.5, 0.7F, 0.01F, 0.3F);  // a robot before it
  remove_goals(kField2012, sight, grid);
  EXPECT_EQ(grid.within(Layer::tall, {3, 0.1F}, 0.1F).area, 0);
  EXPECT_GT(grid.within(Layer::head, {3, 0.1F}, 0.1F).area, 0);
  EXPECT_EQ(grid.within(Layer::body, {-3, 0.7F}, 0.1F).area, 0);
  EXPECT_GT(grid.within(Layer::body, {-2.5F, 0.7F}, 0.1F).area, 0);
}

}  // namespace
}  // namespace robot::truth
