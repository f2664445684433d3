#include "robot/truth/tracks/smoother.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>

#include "robot/truth/tracks/tracker.h"
#include "tests/robot/truth/tracks/images.h"
#include "tests/support/truth_game.h"

namespace robot::truth {
namespace {

const std::vector<Sensor> kSensors{sensor_beside(0)};

struct Recorded {
  std::vector<SensorImage> images;
  std::vector<OwnPose> poses;
};

Recorded recorded_game(std::size_t steps) {
  test::TruthGame game(61);
  test::Random random(62);
  test::Localisation localisation(63);
  test::Watcher watcher;
  Recorded all;
  for (std::size_t i = 0; i < steps; ++i) {
    game.step();
    const std::uint64_t time = at_seconds(static_cast<double>(i) / 30);
    all.images.push_back({0, watcher.look(game, time, random)});
    for (const OwnPose& pose : localisation.poses(game, time)) all.poses.push_back(pose);
  }
  return all;
}

/// A ball that is kicked once, after 1.01 s.
test::Mover kicked_ball(double time) {
  const double rolls = std::max(0., time - 1.01);
  const Eigen::Vector2d direction(0.8, 0.6);
  return {(1.8 - 0.3 * rolls / 2) * rolls * direction,
          rolls > 0 ? ((1.8 - 0.3 * rolls) * direction).eval() : Eigen::Vector2d(0, 0)};
}

/// Returns images that show the kicked ball with a noise of 1 cm; some of them miss it.
std::vector<SensorImage> images_of_kick(std::uint32_t seed) {
  test::Random random(seed);
  std::vector<SensorImage> images;
  for (int i = 0; i < 150; ++i) {
    const SensorImage image = image_of(i / 30., {});
    const Eigen::Vector2d noise = 0.01 * random.normal2();
    images.push_back(random.chance(0.05) ? image : with_ball(image, kicked_ball(i / 30.).position + noise));
  }
  return images;
}

TEST(Smoother, FindsTheVelocityOfAKickedBallBetterThanTheTracker) {
  double online = 0, after = 0;
  int count = 0;
  for (const std::uint32_t seed : {64u, 65u, 66u}) {
    const std::vector<SensorImage> images = images_of_kick(seed);
    const auto truths = smooth(kSensors, images);
    ASSERT_TRUE(truths) << truths.error();
    ASSERT_EQ(truths->size(), images.size());
    Tracker tracker(kSensors);
    for (std::size_t i = 0; i < images.size(); ++i) {
      ASSERT_TRUE(tracker.add(images[i]));
      const auto now = tracker.truth().ball, later = (*truths)[i].ball;
      // the images before and after the kick surround the moment without a velocity
      if (!now || !later || i == 30 || i == 31) continue;
      const Eigen::Vector2d velocity = kicked_ball(static_cast<double>(i) / 30).velocity;
      online += (now->place.velocity - velocity).squaredNorm();
      after += (later->place.velocity - velocity).squaredNorm();
      ++count;
    }
  }
  EXPECT_LT(std::sqrt(after / count), 0.05);
  EXPECT_LT(after, online / 4);
}

TEST(Smoother, BeginsWithTheFirstImageThatShowsAThing) {
  std::vector<SensorImage> images;
  for (int i = 0; i < 30; ++i) images.push_back(with_ball(image_of(i / 30., {{1, 1}}), {0, 0}));
  const auto truths = smooth(kSensors, images);
  ASSERT_TRUE(truths);
  for (const FusedTruth& truth : *truths) {
    ASSERT_EQ(truth.robots.size(), 1u);
    EXPECT_EQ(truth.robots[0].place.track, 1u);
    ASSERT_TRUE(truth.ball);
    EXPECT_EQ(truth.ball->place.sensors, 1u);
  }
}

TEST(Smoother, LeavesOutWhatAnImageDoesNotShow) {
  std::vector<SensorImage> images;
  for (int i = 0; i < 30; ++i) images.push_back(image_of(i / 30., {{1, 1}}));
  images[15] = with_ball(image_of(0.5, {}), {0, 0});
  const auto truths = smooth(kSensors, images);
  EXPECT_TRUE((*truths)[15].robots.empty());
  EXPECT_FALSE((*truths)[15].ball);  // one image is no ball
}

TEST(Smoother, JoinsTheTrailsOfARobotThatWasAwayForLong) {
  std::vector<SensorImage> images;
  for (int i = 0; i < 300; ++i) {
    const bool away = i > 60 && i < 240;
    images.push_back(image_of(i / 30., away ? std::vector<Eigen::Vector2d>{} : std::vector<Eigen::Vector2d>{{1, 1}}));
  }
  const auto truths = smooth(kSensors, images);
  EXPECT_EQ(truths->front().robots[0].place.track, 1u);
  EXPECT_EQ(truths->back().robots[0].place.track, 1u);
}

TEST(Smoother, NamesARobotFromItsFirstImageOn) {
  const Recorded game = recorded_game(150);
  const auto truths = smooth(kSensors, game.images, game.poses);
  std::set<std::uint32_t> names;
  for (const FusedRobot& robot : (*truths)[5].robots)
    if (robot.player) names.insert(10 * *robot.team + *robot.player);
  EXPECT_GE(names.size(), 6u);
}

TEST(Smoother, TakesInputInAnyOrderAndRepeatedImages) {
  Recorded game = recorded_game(30);
  const auto ordered = smooth(kSensors, game.images, game.poses);
  std::vector<SensorImage> twice = game.images;
  twice.insert(twice.end(), game.images.begin(), game.images.end());
  std::reverse(twice.begin(), twice.end());
  const auto other = smooth(kSensors, twice, game.poses);
  ASSERT_EQ(other->size(), ordered->size());
  for (std::size_t i = 0; i < ordered->size(); ++i) {
    ASSERT_EQ((*other)[i].robots.size(), (*ordered)[i].robots.size());
    for (std::size_t k = 0; k < (*ordered)[i].robots.size(); ++k)
      EXPECT_EQ((*other)[i].robots[k].place.position, (*ordered)[i].robots[k].place.position);
  }
}

TEST(Smoother, SaysWhichInputIsWrong) {
  EXPECT_EQ(smooth(kSensors, {image_of(0, {}, 1)}).error(), "image of sensor 2: expected a sensor from 1 to 1");
  EXPECT_EQ(smooth(kSensors, {SensorImage{}}).error(), "sensor 1: an image has no capture time");
  EXPECT_EQ(smooth(std::vector<Sensor>(5), {}).error(), "sensors: expected at most 4, got 5");
  EXPECT_FALSE(smooth(kSensors, {}, {{.capture_ns = 1, .position = {std::nan(""), 0}}}));
  EXPECT_TRUE(smooth(kSensors, {})->empty());
}

}  // namespace
}  // namespace robot::truth
