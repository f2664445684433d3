#include "robot/truth/tags/tag_watcher.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "tests/support/camera_above.h"
#include "tests/support/rendered_pictures.h"
#include "tests/support/tagged_scenes.h"

namespace {

using robot::truth::DepthFrame;
using robot::truth::Detections;
using robot::truth::SeenRobot;
using robot::truth::tags::Camera;
using robot::truth::tags::TagPlan;
using robot::truth::tags::TagWatcher;
using tests::flat_tag;
using tests::kDegree;
using tests::Things;

constexpr int kId = 3;

/// A small camera over a plan of one tag.
class TagWatcherTest : public testing::Test {
 protected:
  static Camera camera() { return tests::camera_above({0, -0.8, 1.7}, {0, 0}, {480, 320}, 420); }

  static TagWatcher new_watcher() {
    TagPlan plan;
    plan.tags[kId] = {.team = 5, .player = 2, .mounting = {.edge = 0.14, .height = 0.5}};
    return *TagWatcher::create(camera(), plan);
  }

  static DepthFrame picture_of(const Things& things) {
    static const tests::Renderer renderer(camera());
    return renderer.render(things, {});
  }

  Detections seen(const Things& things) { return *watcher.look(picture_of(things)); }

  TagWatcher watcher = new_watcher();
};

TEST_F(TagWatcherTest, ARenderedTagIsFoundWhereItIs) {
  for (const double heading : {-2.0, 0.0, 1.0, 3.0}) {
    Things things;
    things.push_back(tests::printed_tag(kId, flat_tag({0.2, 0.1, 0.5}, heading), 0.14));
    const Detections detections = seen(things);
    ASSERT_EQ(detections.robots.size(), 1u);
    const SeenRobot& robot = detections.robots[0];
    EXPECT_LT((robot.place.position - Eigen::Vector2d(0.2, 0.1)).norm(), 0.01);
    EXPECT_LT(std::abs(std::remainder(*robot.heading - heading, 2 * std::numbers::pi)), 1 * kDegree);
    EXPECT_EQ(robot.player, 2u);
  }
}

TEST_F(TagWatcherTest, TheCaptureTimeIsThePictures) {
  DepthFrame picture = picture_of({});
  picture.capture_ns = 42;
  const auto detections = watcher.look(picture);
  ASSERT_TRUE(detections);
  EXPECT_EQ(detections->capture_ns, 42u);
  EXPECT_TRUE(detections->robots.empty());
  EXPECT_FALSE(detections->ball);
}

TEST_F(TagWatcherTest, AnUnknownTagIsIgnoredAndCounted) {
  Things things;
  things.push_back(tests::printed_tag(kId + 1, flat_tag({0.2, 0.1, 0.5}, 1), 0.14));
  EXPECT_TRUE(seen(things).robots.empty());
  EXPECT_EQ(watcher.refused().unknown, 1u);
}

TEST_F(TagWatcherTest, APartlyHiddenTagGivesNothingRatherThanSomethingWrong) {
  int hidden = 0;
  for (int step = 0; step < 24; ++step) {
    const double angle = step * 30 * kDegree, distance = step < 12 ? 0.04 : 0.09;
    Things things;
    things.push_back(tests::printed_tag(kId, flat_tag({0, 0, 0.5}, 0.4), 0.14));
    things.push_back(
        tests::sphere({distance * std::cos(angle), distance * std::sin(angle), 0.54}, 0.03, {0.4f, 0.1f, 0.1f}));
    const Detections detections = seen(things);
    if (detections.robots.empty()) ++hidden;
    for (const SeenRobot& robot : detections.robots) EXPECT_LT(robot.place.position.norm(), 0.02) << step;
  }
  EXPECT_GE(hidden, 12);
}

TEST_F(TagWatcherTest, BlankPicturesShowNothing) {
  DepthFrame picture = tests::black_picture({480, 320});
  for (const int shade : {0, 128, 255}) {
    picture.rgb.assign(picture.rgb.size(), static_cast<std::uint8_t>(shade));
    const auto detections = watcher.look(picture);
    ASSERT_TRUE(detections);
    EXPECT_TRUE(detections->robots.empty());
    EXPECT_FALSE(detections->ball);
  }
}

TEST_F(TagWatcherTest, APictureOfAnotherSizeThanTheCalibrationIsRefused) {
  EXPECT_EQ(watcher.look(tests::black_picture({640, 480})).error(),
            "picture: expected the calibration's size 480x320, got 640x480");
}

TEST(TaggedScenes, TwoCentimetresTwoDegreesAndNoWrongIdentity) {
  std::mt19937 random(5);
  const Camera camera = tests::random_camera(random);
  const tests::Renderer renderer(camera);
  auto watcher = TagWatcher::create(camera, tests::plan_of_scenes());
  ASSERT_TRUE(watcher);
  int found = 0;
  for (int frame = 0; frame < 8; ++frame) {
    const tests::TaggedScene scene = tests::random_scene(random);
    const auto detections = watcher->look(renderer.render(scene.things, scene.conditions));
    ASSERT_TRUE(detections);
    for (const SeenRobot& seen : detections->robots) {
      const auto same = [&](const auto& robot) { return robot.team == seen.team && robot.player == seen.player; };
      const auto robot = std::find_if(scene.robots.begin(), scene.robots.end(), same);
      ASSERT_NE(robot, scene.robots.end());
      EXPECT_EQ(robot->lies, !seen.heading);
      if (robot->lies) continue;
      ++found;
      EXPECT_LT((seen.place.position - robot->place).norm(), 0.02);
      EXPECT_LT(std::abs(std::remainder(*seen.heading - robot->heading, 2 * std::numbers::pi)), 2 * kDegree);
    }
    if (detections->ball) {
      EXPECT_LT((detections->ball->place.position - scene.ball).norm(), 0.02);
    }
  }
  EXPECT_GT(found, 20);
  EXPECT_GT(watcher->refused().unknown, 4u);
}

}  // namespace
