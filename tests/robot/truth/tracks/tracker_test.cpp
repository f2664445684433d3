#include "robot/truth/tracks/tracker.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "tests/robot/truth/tracks/images.h"
#include "tests/support/truth_game.h"

namespace robot::truth {
namespace {

constexpr double kInterval = 1. / 30;  // [s]

/// Shows the robots at these places for `images` images from `begin` [s] on.
double show(Tracker& tracker, double begin, int images, const std::vector<Eigen::Vector2d>& robots) {
  for (int i = 0; i < images; ++i) EXPECT_TRUE(tracker.add(image_of(begin + i * kInterval, robots)));
  return begin + images * kInterval;
}

Tracker one_sensor() { return Tracker({sensor_beside(0)}); }

TEST(Tracker, BeginsATrackWithTheThirdImage) {
  Tracker tracker = one_sensor();
  const double time = show(tracker, 0, 2, {{1, 1}});
  EXPECT_TRUE(tracker.truth().robots.empty());
  show(tracker, time, 1, {{1, 1}});
  ASSERT_EQ(tracker.truth().robots.size(), 1u);
  EXPECT_EQ(tracker.truth().robots[0].place.track, 1u);
}

TEST(Tracker, BeginsNoTrackThatTwoOfFiveImagesShow) {
  Tracker tracker = one_sensor();
  double time = show(tracker, 0, 1, {{1, 1}});
  for (int i = 0; i < 10; ++i) {
    time = show(tracker, time, 3, {});
    time = show(tracker, time, 1, {{1, 1}});
    EXPECT_TRUE(tracker.truth().robots.empty());
  }
}

TEST(Tracker, ReportsOnlyThingsThatTheNewestImageShows) {
  Tracker tracker = one_sensor();
  for (int i = 0; i < 10; ++i) ASSERT_TRUE(tracker.add(with_ball(image_of(i * kInterval, {{1, 1}, {-1, 0}}), {0, 0})));
  EXPECT_EQ(tracker.truth().robots.size(), 2u);
  EXPECT_TRUE(tracker.truth().ball);
  show(tracker, 10 * kInterval, 1, {{1, 1}});
  EXPECT_EQ(tracker.truth().robots.size(), 1u);
  EXPECT_FALSE(tracker.truth().ball);
}

TEST(Tracker, KeepsTheNumberThroughAnOcclusionOfSomeSeconds) {
  Tracker tracker = one_sensor();
  double time = 0;
  for (int i = 0; i < 30; ++i) time = show(tracker, time, 1, {{0.3 * time, 0}, {-2, 0}});
  time = show(tracker, time, 90, {{-2, 0}});
  time = show(tracker, time, 1, {{0.3 * 2, 0.2}, {-2, 0}});
  const FusedTruth truth = tracker.truth();
  ASSERT_EQ(truth.robots.size(), 2u);
  EXPECT_EQ(truth.robots[1].place.track, 2u);
  EXPECT_GT(truth.robots[1].place.position.x(), 0);
}

TEST(Tracker, ForgetsARobotAfterFiveSeconds) {
  Tracker tracker = one_sensor();
  double time = show(tracker, 0, 10, {{1, 1}});
  time = show(tracker, time, 155, {});
  show(tracker, time, 3, {{1, 1}});
  ASSERT_EQ(tracker.truth().robots.size(), 1u);
  EXPECT_EQ(tracker.truth().robots[0].place.track, 2u);
}

TEST(Tracker, KeepsTheNumbersOfTwoRobotsThatCross) {
  test::Random random(41);
  Tracker tracker = one_sensor();
  for (int i = 0; i < 240; ++i) {
    const double x = -1.2 + 0.3 * i * kInterval;
    const Eigen::Vector2d noise = 0.02 * random.normal2();
    ASSERT_TRUE(
        tracker.add(image_of(i * kInterval, {Eigen::Vector2d(x, 0.15) + noise, Eigen::Vector2d(-x, -0.15) - noise})));
  }
  const FusedTruth truth = tracker.truth();
  ASSERT_EQ(truth.robots.size(), 2u);
  EXPECT_GT(truth.robots[0].place.position.x(), 1);
  EXPECT_LT(truth.robots[1].place.position.x(), -1);
}

TEST(Tracker, TakesARobotThatIsSplitInTwoAsOne) {
  Tracker tracker = one_sensor();
  double time = show(tracker, 0, 10, {{1, 1}});
  show(tracker, time, 20, {{1, 1}, {1.1, 1.1}});
  EXPECT_EQ(tracker.truth().robots.size(), 1u);
}

TEST(Tracker, GivesTheBallANewNumberAfterItWasLost) {
  Tracker tracker = one_sensor();
  double time = 0;
  for (int i = 0; i < 10; ++i, time += kInterval) ASSERT_TRUE(tracker.add(with_ball(image_of(time, {}), {0, 0})));
  EXPECT_EQ(tracker.truth().ball->place.track, 1u);
  for (int i = 0; i < 3; ++i, time += kInterval) ASSERT_TRUE(tracker.add(with_ball(image_of(time, {}), {2, 1})));
  EXPECT_FALSE(tracker.truth().ball);
  for (int i = 0; i < 3; ++i, time += kInterval) ASSERT_TRUE(tracker.add(with_ball(image_of(time, {}), {2, 1})));
  EXPECT_EQ(tracker.truth().ball->place.track, 2u);
}

TEST(Tracker, ReportsHeadingAndIdentityOfATag) {
  Tracker tracker = one_sensor();
  for (int i = 0; i < 10; ++i) {
    SensorImage image = image_of(i * kInterval, {{1, 1}, {0, 0}});
    SeenRobot& robot = image.detections.robots[0];
    robot.team = 5;
    robot.player = 3;
    robot.heading = 1.5;
    robot.heading_deviation = 0.02;
    ASSERT_TRUE(tracker.add(image));
  }
  const FusedTruth truth = tracker.truth();
  ASSERT_EQ(truth.robots.size(), 2u);
  const bool first = truth.robots[0].place.position.x() > 0.5;
  const FusedRobot& tagged = truth.robots[first ? 0 : 1];
  EXPECT_EQ(tagged.team, 5u);
  EXPECT_EQ(tagged.player, 3u);
  EXPECT_EQ(tagged.heading, 1.5);
  EXPECT_EQ(tagged.heading_deviation, 0.02);
  EXPECT_FALSE(truth.robots[first ? 1 : 0].team);
  EXPECT_FALSE(truth.robots[first ? 1 : 0].heading);
}

TEST(Tracker, ReportsAFallenRobot) {
  Tracker tracker = one_sensor();
  for (int i = 0; i < 10; ++i) {
    SensorImage image = image_of(i * kInterval, {{1, 1}});
    image.detections.robots[0].height = 0.2;
    ASSERT_TRUE(tracker.add(image));
  }
  EXPECT_EQ(tracker.truth().robots[0].fallen, true);
  SensorImage image = image_of(1, {{1, 1}});
  image.detections.robots[0].height = 0;
  Tracker without = one_sensor();
  for (int i = 0; i < 3; ++i) {
    image.detections.capture_ns += 33'000'000;
    ASSERT_TRUE(without.add(image));
  }
  EXPECT_FALSE(without.truth().robots[0].fallen);
}

TEST(Tracker, FusesTwoSensorsAndCountsThem) {
  Tracker tracker({sensor_beside(0.02), sensor_beside(0.02)});
  for (int i = 0; i < 30; ++i) {
    ASSERT_TRUE(tracker.add(image_of(i * kInterval, {{1, 1}}, 0)));
    ASSERT_TRUE(tracker.add(image_of(i * kInterval + 0.01, {{1.02, 1}, {0, 0}}, 1)));
  }
  const FusedTruth truth = tracker.truth();
  ASSERT_EQ(truth.robots.size(), 2u);
  const bool first = truth.robots[0].place.position.x() > 0.5;
  const FusedPlace& both = truth.robots[first ? 0 : 1].place;
  const FusedPlace& one = truth.robots[first ? 1 : 0].place;
  EXPECT_EQ(both.sensors, 2u);
  EXPECT_EQ(one.sensors, 1u);
  EXPECT_NEAR(both.position.x(), 1.01, 0.004);
  EXPECT_GT(one.covariance(0, 0), 0.02 * 0.02);
  EXPECT_NEAR(both.covariance(0, 0) / one.covariance(0, 0), 0.5, 0.1);
  EXPECT_TRUE(truth.disagreements.empty());
}

TEST(Tracker, ReportsADisagreementInOneSentence) {
  Tracker tracker({sensor_beside(0.005), sensor_beside(0.005)});
  for (int i = 0; i < 30; ++i) {
    ASSERT_TRUE(tracker.add(with_ball(image_of(i * kInterval, {{1, 1}}, 0), {0, 0})));
    ASSERT_TRUE(tracker.add(with_ball(image_of(i * kInterval, {{1.14, 1}}, 1), {0, 0})));
  }
  const FusedTruth truth = tracker.truth();
  ASSERT_EQ(truth.robots.size(), 1u);
  ASSERT_EQ(truth.disagreements.size(), 1u);
  EXPECT_EQ(truth.disagreements[0].substr(0, 36), "sensors 1 and 2 place robot 1 at (1.");
  EXPECT_NE(truth.disagreements[0].find("m 14 cm apart, expected 4 cm"), std::string::npos) << truth.disagreements[0];
}

TEST(Tracker, SaysWhyItDoesNotUseAnImage) {
  Tracker tracker = one_sensor();
  show(tracker, 10, 10, {{1, 1}});
  EXPECT_EQ(tracker.add(image_of(10, {}, 1)).error(), "image of sensor 2: expected a sensor from 1 to 1");
  EXPECT_EQ(tracker.add(image_of(10, {})).error(),
            "sensor 1: an image came 0.30 s after a newer one, expected at most 0.2 s");
  EXPECT_EQ(tracker.add(image_of(10 + 9 * kInterval, {})).error(),
            "sensor 1: the image of 1700000010.300 s came twice");
  EXPECT_EQ(tracker.add({}).error(), "sensor 1: an image has no capture time");
  EXPECT_EQ(tracker.refused().late, 1u);
  EXPECT_EQ(tracker.refused().repeated, 1u);
}

TEST(Tracker, BeginsAnewWhenTheClockWasSetBack) {
  Tracker tracker = one_sensor();
  show(tracker, 3600, 10, {{1, 1}});
  for (int i = 0; i < 40; ++i) EXPECT_EQ(bool(tracker.add(image_of(i * kInterval, {{1, 1}}))), i >= 30) << i;
  EXPECT_EQ(tracker.refused().restarts, 1u);
  ASSERT_EQ(tracker.truth().robots.size(), 1u);
  EXPECT_EQ(tracker.truth().robots[0].place.track, 2u);
}

TEST(Tracker, SurvivesAGapOfAnHour) {
  Tracker tracker = one_sensor();
  for (int i = 0; i < 10; ++i) ASSERT_TRUE(tracker.add(with_ball(image_of(i * kInterval, {{1, 1}}), {0, 0})));
  for (int i = 0; i < 3; ++i) ASSERT_TRUE(tracker.add(with_ball(image_of(3600 + i * kInterval, {{1, 1}}), {0, 0})));
  const FusedTruth truth = tracker.truth();
  ASSERT_EQ(truth.robots.size(), 1u);
  EXPECT_EQ(truth.robots[0].place.track, 2u);
  EXPECT_EQ(truth.ball->place.track, 2u);
  EXPECT_TRUE(truth.robots[0].place.covariance.allFinite());
}

TEST(Tracker, WorksWithThreeImagesASecond) {
  Tracker tracker = one_sensor();
  for (int i = 0; i < 30; ++i) ASSERT_TRUE(tracker.add(image_of(i / 3., {{0.1 * i, 0}, {-0.1 * i, 1}})));
  const FusedTruth truth = tracker.truth();
  ASSERT_EQ(truth.robots.size(), 2u);
  EXPECT_EQ(truth.robots[1].place.track, 2u);
  EXPECT_NEAR(std::abs(truth.robots[0].place.velocity.x()), 0.3, 0.05);
}

TEST(Tracker, CountsDetectionsThatItCannotUse) {
  Tracker tracker = one_sensor();
  show(tracker, 0, 5, {{1, 1}, {std::nan(""), 0}});
  EXPECT_EQ(tracker.refused().detections, 5u);
  EXPECT_EQ(tracker.truth().robots.size(), 1u);
}

TEST(Tracker, FollowsNoMoreRobotsThanItsMemoryHolds) {
  test::Random random(42);
  Tracker tracker = one_sensor();
  for (int i = 0; i < 100; ++i) {
    std::vector<Eigen::Vector2d> robots(60);
    for (Eigen::Vector2d& robot : robots) robot = {random.uniform(-5, 5), random.uniform(-3, 3)};
    ASSERT_TRUE(tracker.add(image_of(i * kInterval, robots)));
    EXPECT_LE(tracker.truth().robots.size(), kMostRobots);
  }
}

}  // namespace
}  // namespace robot::truth
