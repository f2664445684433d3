// Robots, people and goals in synthetic images. bench_truth measures the same over many more images.
#include <gtest/gtest.h>

#include <cmath>

#include "tests/robot/truth/detection/watched.h"

namespace robot::truth {
namespace {

TEST(Robots, StandWhereTheyAreSeen) {
  Watched watched(mast(kField2012));
  double sum = 0, squares = 0, worst = 0;
  int count = 0;
  for (std::uint64_t number = 0; number < 10; ++number) {
    const auto turn = static_cast<double>(number);
    Scene scene;
    for (const auto& [x, y] : {std::pair{-1., -1.2}, {0.5, -0.6}, {-0.4, 0.3}, {1.3, 0.8}, {-1.5, 1.4}, {0.2, 1.6}})
      scene.robots.push_back({.x = x + 0.02 * turn, .y = y, .heading = x + 0.9 * turn, .arms = 0.12 * turn});
    const Detections seen = watched.see(scene, number);
    ASSERT_EQ(seen.robots.size(), scene.robots.size());
    for (const SceneRobot& robot : scene.robots) {
      const double error = nearest_robot(seen, robot.x, robot.y);
      sum += error, worst = std::max(worst, error), ++count;
      for (const SeenRobot& each : seen.robots)
        if ((each.place.position - Eigen::Vector2d(robot.x, robot.y)).norm() == error)
          squares += normalised_error_squared(each.place, robot.x, robot.y);
    }
  }
  EXPECT_LT(sum / count, 0.012);
  EXPECT_LT(worst, 0.04);
  EXPECT_NEAR(squares / count, 2, 0.9) << "the covariance is honest";
}

TEST(Robots, ThatTouchAreTwo) {
  Watched watched;
  for (const double heading : {0., 0.8, 1.6}) {
    // beside each other, one behind the other, and in between
    const double x = 0.18 * std::cos(heading), y = 0.18 * std::sin(heading);
    Scene scene;
    scene.robots = {{.x = x, .y = y, .heading = heading}, {.x = -x, .y = -y, .heading = 2 - heading, .arms = 1}};
    const Detections seen = watched.see(scene);
    EXPECT_EQ(seen.robots.size(), 2U) << heading;
    for (const SceneRobot& robot : scene.robots) EXPECT_LT(nearest_robot(seen, robot.x, robot.y), 0.04) << heading;
  }
}

TEST(Robots, AtTheFarEndAreNotSplitByTheNoise) {
  Watched watched(mast(kField2012));
  for (std::uint64_t number = 0; number < 8; ++number) {
    const Scene scene{.robots = {{.x = 2.2, .y = 1.8, .heading = static_cast<double>(number)}}};
    EXPECT_EQ(watched.see(scene, number).robots.size(), 1U) << number;
  }
}

TEST(Robots, ThatLieAreSeenAsLow) {
  Watched watched;
  const Detections seen = watched.see(Scene{.robots = {{.x = 0.3, .y = 0.2, .heading = 1, .fallen = true}, {.x = -1}}});
  ASSERT_EQ(seen.robots.size(), 2U);
  for (const SeenRobot& robot : seen.robots) {
    const bool lies = robot.place.position.x() > -0.5;
    EXPECT_NEAR(robot.height, lies ? 0.25 : 0.58, lies ? 0.12 : 0.03);
    EXPECT_LT((robot.place.position - Eigen::Vector2d(lies ? 0.3 : -1, lies ? 0.2 : 0)).norm(), lies ? 0.08 : 0.03);
  }
}

TEST(Robots, ArePeopleNever) {
  Watched watched;
  for (std::uint64_t number = 0; number < 8; ++number) {
    const auto turn = static_cast<double>(number);
    const Scene scene{
        .people = {{.x = -1 + 0.3 * turn, .y = -0.5 + 0.35 * turn, .heading = turn, .stride = 0.1 * turn - 0.4}}};
    EXPECT_TRUE(watched.see(scene, number).robots.empty()) << number;
  }
}

TEST(Robots, BesideAPersonAreSeen) {
  Watched watched;
  const Scene scene{.robots = {{.x = 0.1, .y = 0}}, .people = {{.x = 0.7, .y = 0.2}}};
  const Detections seen = watched.see(scene);
  ASSERT_EQ(seen.robots.size(), 1U);
  EXPECT_LT(nearest_robot(seen, 0.1, 0), 0.03);
}

TEST(Robots, AtTheBorderOfTheImageAreLeftOut) {
  const SensorPose pose = mast(kField2012, -1, 0, kHalf);
  Watched watched(pose);
  const double y = 0.2;
  for (double x = 1.8; x < 2.6; x += 0.05) {
    const Detections seen = watched.see(Scene{.robots = {{.x = x, .y = y}}});
    for (const SeenRobot& robot : seen.robots)
      EXPECT_LT((robot.place.position - Eigen::Vector2d(x, y)).norm(), 0.05) << x;
  }
  EXPECT_TRUE(watched.see(Scene{.robots = {{.x = 2.6, .y = y}}}).robots.empty());
}

TEST(Robots, OutsideOfTheCarpetDoNotCount) {
  Watched watched(looking({0, -2, 2}, {0, 2.5, 0}, kHalf));
  EXPECT_TRUE(watched.see(Scene{.robots = {{.x = 0, .y = 3.4}}}).robots.empty());
}

}  // namespace
}  // namespace robot::truth
