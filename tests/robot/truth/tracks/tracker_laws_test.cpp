// Laws of the tracker: they hold for every recording.
#include <gtest/gtest.h>

#include <algorithm>

#include "robot/truth/tracks/tracker.h"
#include "tests/robot/truth/tracks/images.h"
#include "tests/support/truth_game.h"

namespace robot::truth {
namespace {

const std::vector<Sensor>& two_sensors() {
  static const std::vector<Sensor> sensors{sensor_beside(0.01, 0.003), sensor_beside(0.02)};
  return sensors;
}

/// Returns the images of a game of two sensors, the second one 12 ms later.
std::vector<SensorImage> images_of_game(std::size_t steps) {
  test::TruthGame game(51);
  test::Random random(52);
  test::Watcher near, far;
  far.place = {0, 4};
  std::vector<SensorImage> images;
  for (std::size_t i = 0; i < steps; ++i) {
    game.step();
    const double time = static_cast<double>(i) / 30;
    images.push_back({0, near.look(game, at_seconds(time), random)});
    images.push_back({1, far.look(game, at_seconds(time + 0.012), random)});
  }
  return images;
}

FusedTruth truth_after(const std::vector<SensorImage>& images, const std::vector<Sensor>& sensors = two_sensors()) {
  Tracker tracker(sensors);
  for (const SensorImage& image : images) (void)tracker.add(image);
  return tracker.truth();
}

void expect_same(const FusedPlace& a, const FusedPlace& b, double tolerance) {
  EXPECT_EQ(a.track, b.track);
  EXPECT_EQ(a.sensors, b.sensors);
  EXPECT_LE((a.position - b.position).norm(), tolerance);
  EXPECT_LE((a.velocity - b.velocity).norm(), tolerance);
  EXPECT_LE((a.covariance - b.covariance).norm(), tolerance);
}

void expect_same(const FusedTruth& a, const FusedTruth& b, double tolerance = 0) {
  ASSERT_EQ(a.robots.size(), b.robots.size());
  EXPECT_GE(a.robots.size(), 5u);
  for (std::size_t i = 0; i < a.robots.size(); ++i) expect_same(a.robots[i].place, b.robots[i].place, tolerance);
  ASSERT_EQ(a.ball.has_value(), b.ball.has_value());
  if (a.ball) expect_same(a.ball->place, b.ball->place, tolerance);
}

TEST(TrackerLaws, TheOrderOfDetectionsInAnImageDoesNotMatter) {
  std::vector<SensorImage> images = images_of_game(45);
  const FusedTruth truth = truth_after(images);
  for (SensorImage& image : images) std::reverse(image.detections.robots.begin(), image.detections.robots.end());
  expect_same(truth_after(images), truth);
}

TEST(TrackerLaws, OutOfOrderInputEqualsOrderedInput) {
  std::vector<SensorImage> images = images_of_game(45);
  const FusedTruth truth = truth_after(images);
  // up to 150 ms late; the newest image stays the last one
  test::Random random(53);
  for (std::size_t i = 0; i + 10 < images.size(); i += 9)
    std::reverse(images.begin() + static_cast<std::ptrdiff_t>(i), images.begin() + static_cast<std::ptrdiff_t>(i + 8));
  expect_same(truth_after(images), truth);
}

TEST(TrackerLaws, ImagesThatComeTwiceChangeNothing) {
  const std::vector<SensorImage> images = images_of_game(20);
  std::vector<SensorImage> twice;
  for (const SensorImage& image : images) twice.insert(twice.end(), {image, image});
  expect_same(truth_after(twice), truth_after(images));
}

TEST(TrackerLaws, AShiftOfAllTimesChangesOnlyTimes) {
  std::vector<SensorImage> images = images_of_game(45);
  const FusedTruth truth = truth_after(images);
  constexpr std::uint64_t shift = 86'400'000'000'123;
  for (SensorImage& image : images) {
    image.detections.capture_ns += shift;
    image.detections.detected_ns += shift;
  }
  const FusedTruth later = truth_after(images);
  expect_same(later, truth);
  EXPECT_EQ(later.capture_ns, truth.capture_ns + shift);
  EXPECT_EQ(later.detected_ns, truth.detected_ns + shift);
}

TEST(TrackerLaws, MirroredMeasurementsGiveMirroredTracks) {
  // sensors without errors of their poses: mirrored ones would need mirrored poses
  const std::vector<Sensor> exact{sensor_beside(0), sensor_beside(0)};
  std::vector<SensorImage> images = images_of_game(45);
  const FusedTruth truth = truth_after(images, exact);
  const auto mirror = [](Place& place) {
    place.position.y() *= -1;
    place.covariance(0, 1) = place.covariance(1, 0) = -place.covariance(1, 0);
  };
  for (SensorImage& image : images) {
    for (SeenRobot& robot : image.detections.robots) mirror(robot.place);
    if (image.detections.ball) mirror(image.detections.ball->place);
  }
  FusedTruth mirrored = truth_after(images, exact);
  for (FusedRobot& robot : mirrored.robots) {
    robot.place.position.y() *= -1;
    robot.place.velocity.y() *= -1;
    robot.place.covariance(0, 1) = robot.place.covariance(1, 0) = -robot.place.covariance(1, 0);
  }
  mirrored.ball.reset();
  FusedTruth robots_only = truth;
  robots_only.ball.reset();
  expect_same(mirrored, robots_only, 1e-9);
}

TEST(TrackerLaws, ABallAtConstantDecelerationHasTheKnownVelocity) {
  test::Random random(54);
  Tracker tracker({sensor_beside(0)});
  double squares = 0;
  for (int i = 0; i < 90; ++i) {
    const double t = i / 30.;
    const Eigen::Vector2d noise = 0.01 * random.normal2();
    const Eigen::Vector2d ball = Eigen::Vector2d(0.8, 0.6) * (1.2 * t - 0.3 * t * t / 2) + noise;
    ASSERT_TRUE(tracker.add(with_ball(image_of(t, {}), ball)));
    if (i < 15) continue;
    const Eigen::Vector2d velocity = Eigen::Vector2d(0.8, 0.6) * (1.2 - 0.3 * t);
    squares += (tracker.truth().ball->place.velocity - velocity).squaredNorm() / 75;
  }
  EXPECT_LT(std::sqrt(squares), 0.09);
}

}  // namespace
}  // namespace robot::truth
