#include "robot/lab/import/resting_ball.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <random>

#include "proto/foresight/truth.pb.h"
#include "proto/foresight/vision.pb.h"
#include "robot/core/files.h"
#include "robot/lab/import/bhuman2009.h"
#include "robot/lab/import/orange_ball.h"
#include "tests/support/bhuman2009_writer.h"
#include "tests/support/real_data.h"
#include "tests/support/recording_sink.h"

namespace robot::lab {
namespace {

constexpr std::uint64_t kSecondNs = 1'000'000'000;

/// A grey picture with orange ellipses.
class Painted {
 public:
  static constexpr int kWidth = 320, kHeight = 240;

  void ellipse(double x, double y, double half_width, double half_height) {
    for (int row = 0; row < kHeight; ++row)
      for (int column = 0; column < kWidth; column += 2)
        if (std::pow((column + 1 - x) / half_width, 2) + std::pow((row + 0.5 - y) / half_height, 2) < 1)
          colour(column, row, 80, 190);
  }

  void disc(double x, double y, double radius) { ellipse(x, y, radius, radius); }

  void colour(int column, int row, int blue, int red) {
    const auto i = 2 * static_cast<std::size_t>(row * kWidth + column / 2 * 2);
    yuyv_[i + 1] = static_cast<char>(blue), yuyv_[i + 3] = static_cast<char>(red);
  }

  std::optional<FoundBall> find(int last_row = 200) const {
    return find_orange_ball({.width = kWidth, .height = kHeight, .yuyv = yuyv_}, last_row);
  }

 private:
  std::string yuyv_ = std::string(std::size_t{2} * kWidth * kHeight, static_cast<char>(128));
};

TEST(OrangeBall, FindsCentreAndRadius) {
  for (const double radius : {5., 10., 20., 40.}) {
    Painted picture;
    picture.disc(150.3, 100.7, radius);
    const auto ball = picture.find();
    ASSERT_TRUE(ball) << radius;
    EXPECT_NEAR(ball->x, 150.3, 1);
    EXPECT_NEAR(ball->y, 100.7, 0.5);
    EXPECT_NEAR(ball->radius, radius, 0.4);
    EXPECT_NEAR(ball->width, 2 * radius, 3);
  }
}

TEST(OrangeBall, AShineInTheMiddleBelongsToIt) {
  Painted whole, shining;
  whole.disc(150, 100, 20), shining.disc(150, 100, 20);
  for (int row = 95; row < 103; ++row)
    for (int column = 144; column < 154; ++column) shining.colour(column, row, 128, 128);
  ASSERT_TRUE(whole.find() && shining.find());
  EXPECT_DOUBLE_EQ(whole.find()->radius, shining.find()->radius);
}

TEST(OrangeBall, TheLargestRoundPatchCounts) {
  Painted picture;
  picture.ellipse(160, 60, 100, 20);  // no ball
  picture.disc(60, 150, 12);
  picture.disc(250, 150, 8);
  const auto ball = picture.find();
  ASSERT_TRUE(ball);
  EXPECT_NEAR(ball->x, 60, 1);
}

TEST(OrangeBall, APatchThatTheBorderCutsDoesNotCount) {
  for (const auto& [x, y] : {std::pair{5., 100.}, {315., 100.}, {150., 5.}, {150., 195.}}) {
    Painted picture;
    picture.disc(x, y, 15);
    EXPECT_FALSE(picture.find()) << x << ' ' << y;
  }
  Painted picture;
  picture.disc(150, 195, 15);
  EXPECT_TRUE(picture.find(240)) << "below the last row are the robot's own colours";
}

TEST(OrangeBall, APictureWithoutBytesHasNoBall) {
  EXPECT_FALSE(find_orange_ball({}, 100));
  EXPECT_FALSE(find_orange_ball({.width = 320, .height = 240, .yuyv = "short"}, 200));
}

/// A robot that walks 1.4 m to a ball. It sees it five times a second, with a camera whose tilt errs. After 14 s the ball rolls.
struct Approach {
  std::vector<OdometryAt> odometry;
  std::vector<BallSighting> sightings;

  explicit Approach(std::uint64_t seed) {
    std::mt19937_64 random(seed);
    std::normal_distribution<double> normal;
    for (int i = 0; i < 200; ++i) {
      const auto at_ns = 1000 * kSecondNs + static_cast<std::uint64_t>(i) * kSecondNs / 10;
      const double x = std::min(1.4, 0.014 * i);
      odometry.push_back({.at_ns = at_ns, .x = x, .y = 0, .heading = 0});
      if (i % 2 != 0) continue;
      const double ball_x = i < 140 ? 1.6 : 1.6 + std::min(2., 0.1 * (i - 139)), distance = ball_x - x;
      const double stretch = 1 + 0.01 * normal(random) * (0.4 * 0.4 + distance * distance) / (0.4 * distance);
      sightings.push_back({.at_ns = at_ns, .x = stretch * distance, .y = stretch * 0.1, .height = 0.44});
    }
  }
};

TEST(RestingBall, OnePlaceFitsAllPictures) {
  for (std::uint64_t seed = 1; seed <= 5; ++seed) {
    const Approach approach(seed);
    const auto rest = find_rest(approach.sightings, approach.odometry);
    ASSERT_TRUE(rest) << rest.error();
    EXPECT_NEAR(rest->x, 1.6, 0.01);
    EXPECT_NEAR(rest->y, 0.1, 0.01);
    EXPECT_LT(rest->way_share, 0.08);
  }
}

TEST(RestingBall, TheRestEndsBeforeTheBallMoves) {
  const Approach approach(1);
  const auto rest = find_rest(approach.sightings, approach.odometry);
  ASSERT_TRUE(rest) << rest.error();
  EXPECT_EQ(rest->begin_ns, 1000 * kSecondNs);
  EXPECT_NEAR(static_cast<double>(rest->end_ns) * 1e-9, 1014, 0.41);
  EXPECT_NEAR(rest->rolled, 2, 0.2);
  EXPECT_NEAR(rest->direction, 0, 0.05);
}

TEST(RestingBall, SinglePlacesElsewhereHardlyCount) {
  Approach approach(1);
  for (std::size_t i = 0; i < approach.sightings.size(); i += 9) approach.sightings[i].y += 1.5;
  const auto rest = find_rest(approach.sightings, approach.odometry);
  ASSERT_TRUE(rest) << rest.error();
  EXPECT_NEAR(rest->x, 1.6, 0.015);
  EXPECT_NEAR(rest->y, 0.1, 0.015);
}

TEST(RestingBall, TooFewPicturesAreRefused) {
  Approach approach(1);
  approach.sightings.resize(4);
  EXPECT_EQ(find_rest(approach.sightings, approach.odometry).error(),
            "expected at least 10 pictures with a whole orange ball at one place, got 4");
  EXPECT_FALSE(find_rest({}, {}));
}

TEST(RestingBall, TimesOfDaysAreWrong) {
  Approach approach(1);
  for (OdometryAt& robot : approach.odometry) robot.at_ns *= 1'000'000;
  for (BallSighting& ball : approach.sightings) ball.at_ns *= 1'000'000;
  const auto rest = find_rest(approach.sightings, approach.odometry);
  ASSERT_FALSE(rest);
  EXPECT_TRUE(rest.error().ends_with("hours: expected at most one, so the times are wrong")) << rest.error();
}

TEST(RestingBall, ARecordingWithoutABallHasNoTruth) {
  ::tests::Bhuman2009Writer writer;
  writer.cognition({.time_ms = 1, .width = 16, .height = 8, .y = 100, .u = 128, .v = 128});
  ::tests::RecordingSink sink;
  const auto report = import_with_ball(sink, [&](ImportSink& to) { return import_bhuman2009(writer.file(), 0, to); });
  ASSERT_TRUE(report) << report.error();
  EXPECT_EQ(report->warnings.back(),
            "no truth by odometry: expected at least 10 pictures with a whole orange ball at one place, got 0");
  EXPECT_EQ(report->messages.at("vision"), 1u);
  ASSERT_EQ(sink.of<foresight::Vision>("vision").size(), 1u);
  EXPECT_FALSE(sink.of<foresight::Vision>("vision")[0]->has_ball());
}

TEST(RestingBall, EndsWithTheErrorOfTheSink) {
  ::tests::Bhuman2009Writer writer;
  writer.cognition({.time_ms = 1, .width = 16, .height = 8, .y = 100, .u = 128, .v = 128});
  ::tests::FullSink sink;
  const auto report = import_with_ball(sink, [&](ImportSink& to) { return import_bhuman2009(writer.file(), 0, to); });
  ASSERT_FALSE(report);
  EXPECT_EQ(report.error(), "disk full");
}

TEST(RestingBallRecording, TheBallOf2009LiesUntilTheKick) {
  REAL_DATA_OR_SKIP(path, "bhuman2009/logfile.log");
  const Result<std::string> bytes = read_file(path, 1 << 24);
  ASSERT_TRUE(bytes);
  ::tests::RecordingSink sink;
  const auto report = import_with_ball(sink, [&](ImportSink& to) { return import_bhuman2009(*bytes, 0, to); });
  ASSERT_TRUE(report) << report.error();
  EXPECT_EQ(report->messages.at("vision"), 160u);
  const auto truths = sink.of<foresight::GroundTruth>("/truth/world");
  EXPECT_NEAR(static_cast<double>(truths.size()) / 30, 23, 0.2) << "[s] from the first picture to the kick";
  const auto& first = *truths.front();
  EXPECT_NEAR(std::hypot(first.ball().x() - first.robots(0).x(), first.ball().y() - first.robots(0).y()), 1.6, 0.1);
  EXPECT_NE(report->about.find("then it rolls about 2.9 m, -0.13 rad"), std::string::npos) << report->about;
}

}  // namespace
}  // namespace robot::lab
