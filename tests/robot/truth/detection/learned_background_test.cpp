// Detection against images of the empty field.
#include <gtest/gtest.h>

#include "tests/robot/truth/detection/watched.h"

namespace robot::truth {
namespace {

void learn(Watched& watched, const Scene& scene, int images) {
  for (int i = 0; i < images; ++i) {
    const Result<void> learned =
        watched.detector().learn_background(watched.frame(scene, 100 + static_cast<std::uint64_t>(i)));
    ASSERT_TRUE(learned) << learned.error();
  }
}

const Scene kCrate{.robots = {{.x = 0.9, .y = 0.5}}};  // any thing that always stands there

TEST(LearnedBackground, IsNoRobot) {
  Watched watched;
  EXPECT_EQ(watched.see(kCrate).robots.size(), 1U);
  learn(watched, kCrate, 5);
  EXPECT_TRUE(watched.see(kCrate).robots.empty());
}

TEST(LearnedBackground, LeavesOtherRobotsAndTheBallWhereTheyAre) {
  Watched watched(mast(kField2012), {.orange_ball = false});
  learn(watched, {}, 5);
  Scene scene{.robots = {{.x = -0.5, .y = 0.2}, {.x = 0.7, .y = 1.3}}};
  scene.ball = SceneBall{.x = 0.1, .y = -0.3};
  const Detections seen = watched.see(scene);
  EXPECT_EQ(seen.robots.size(), 2U);
  for (const SceneRobot& robot : scene.robots) EXPECT_LT(nearest_robot(seen, robot.x, robot.y), 0.04);
  ASSERT_TRUE(seen.ball);
  EXPECT_LT((seen.ball->place.position - Eigen::Vector2d(0.1, -0.3)).norm(), 0.02);
}

TEST(LearnedBackground, KeepsNoTraceOfAPersonWhoWalksThrough) {
  Watched watched;
  learn(watched, {}, 4);
  learn(watched, kCrate, 3);
  EXPECT_EQ(watched.see(kCrate).robots.size(), 1U);
}

TEST(LearnedBackground, IsTheMedianOfTheLast15Images) {
  Watched watched;
  EXPECT_EQ(watched.detector().background_images(), 0U);
  learn(watched, kCrate, 9);
  EXPECT_EQ(watched.detector().background_images(), 9U);
  learn(watched, {}, 15);
  EXPECT_EQ(watched.detector().background_images(), 15U);
  EXPECT_EQ(watched.see(kCrate).robots.size(), 1U);
}

TEST(LearnedBackground, DoesNotMakeThingsOutsideOfTheCarpetVisible) {
  Watched watched(looking({0, -2, 2}, {0, 2.5, 0}, kHalf));
  learn(watched, {}, 3);
  EXPECT_TRUE(watched.see(Scene{.robots = {{.x = 0, .y = 3.4}}}).robots.empty());
}

}  // namespace
}  // namespace robot::truth
