// A simulated game that a sensor beside the field recorded, and its robots by their own clocks.
#include "robot/app/truth/smooth_session.h"

#include <gtest/gtest.h>

#include <cmath>
#include <map>

#include "robot/app/truth/sensor_messages.h"
#include "robot/app/truth/truth_writer.h"
#include "robot/logging/sessions/read_all.h"
#include "robot/logging/sessions/session_writer.h"
#include "robot/memory/schema.h"
#include "robot/truth/tracks/tracker.h"
#include "tests/support/recorded_truth.h"
#include "tests/support/temporary_folder.h"
#include "tests/support/truth_game.h"

namespace robot::app {
namespace {

using foresight::GroundTruth;
using Truths = std::vector<logging::Recorded<GroundTruth>>;

constexpr double kNoise = 0.02;  // [m] of a seen place

truth::SensorPose mast() {
  truth::SensorPose pose;
  const Eigen::Vector3d forward = Eigen::Vector3d(0, 3, -2).normalized(), right(1, 0, 0);
  pose.field_from_sensor.linear() << right, forward.cross(right), forward;
  pose.field_from_sensor.translation() << 0, -5, 2;
  pose.covariance.diagonal().segment<3>(3).setConstant(1e-6);
  return pose;
}

truth::Place seen_near(float x, float y, test::Random& random) {
  return {.position = Eigen::Vector2d(x, y) + kNoise * random.normal2(),
          .covariance = kNoise * kNoise * Eigen::Matrix2d::Identity()};
}

/// The detections of the sensor: places without names.
truth::Detections seen_of(const GroundTruth& truth, std::uint64_t capture_ns, test::Random& random) {
  truth::Detections seen{.capture_ns = capture_ns, .detected_ns = capture_ns};
  for (const GroundTruth::TrueRobot& robot : truth.robots())
    seen.robots.push_back({.place = seen_near(robot.x(), robot.y(), random), .height = 0.57});
  if (truth.has_ball()) seen.ball = truth::SeenBall{.place = seen_near(truth.ball().x(), truth.ball().y(), random)};
  return seen;
}

template <class Message>
void put(logging::SessionWriter& writer, const std::string& topic, std::uint64_t capture_ns, const Message& message) {
  const memory::ChannelInfo info{.topic = topic, .schema = memory::schema_of(*Message::descriptor())};
  ASSERT_TRUE(writer.write(info, capture_ns, message.SerializeAsString()));
}

foresight::TruthSensor message_of(const truth::Detections& seen, const truth::SensorPose& pose) {
  foresight::TruthSensor message;
  message.set_state(foresight::TruthSensor::STATE_WATCHING);
  message.set_address("freenect:0");
  to_proto(pose.intrinsics, *message.mutable_pinhole());
  to_proto(pose, *message.mutable_place());
  to_proto(seen, message);
  return message;
}

struct SmoothedGame : testing::Test {
  /// Records the game, and the sensor that watches it into the session "watched". The first images come from before a
  /// calibration.
  void record(double seconds, std::map<std::string, double> ahead, std::size_t before_calibration = 0) {
    tests::record_game(folder.path(),
                       {.from = 30, .seconds = static_cast<float>(seconds), .ahead = std::move(ahead), .change = {}});
    known = logging::read_in_order<GroundTruth>(*logging::open_session(folder / "truth"), "/truth/world");
    auto writer = *logging::SessionWriter::create(folder / "watched", {.robot = "truth"});
    test::Random random(5);
    truth::SensorPose pose = mast();
    pose.field_from_sensor.translation().x() += 1;
    truth::Tracker tracker({{.pose = mast()}});
    for (const auto& [value, capture_ns] : known) {
      if (before_calibration == 0) pose = mast();
      if (before_calibration > 0) --before_calibration;
      const truth::Detections seen = seen_of(value, capture_ns, random);
      put(*writer, "/truth/1/sensor", capture_ns, message_of(seen, pose));
      if (two_sensors) {
        const truth::Detections later = seen_of(value, capture_ns + kMillisecond, random);
        put(*writer, "/truth/2/sensor", later.capture_ns, message_of(later, mast()));
      }
      ASSERT_TRUE(tracker.add({.sensor = 0, .detections = seen}));
      GroundTruth live;
      to_proto(tracker.truth(), capture_ns, live);
      put(*writer, "/truth/world", capture_ns, live);
    }
    ASSERT_TRUE(writer->close());
  }

  Result<Smoothed> smooth(std::vector<std::filesystem::path> robots) const {
    return smooth_session({.truth = folder / "watched", .robots = std::move(robots), .session = folder / "smoothed"});
  }

  Truths read(const char* session) const {
    return logging::read_in_order<GroundTruth>(*logging::open_session(folder / session), "/truth/world");
  }

  const GroundTruth& truth_at(std::uint64_t capture_ns) const {
    return std::ranges::find(known, capture_ns, &logging::Recorded<GroundTruth>::capture_ns)->value;
  }

  /// Returns the error [m, rms] of the ball in a session.
  double ball_error(const char* session) const {
    double sum = 0;
    int count = 0;
    for (const auto& [value, capture_ns] : read(session)) {
      const GroundTruth& truth = truth_at(capture_ns);
      if (!value.has_ball() || !truth.has_ball()) continue;
      sum += std::pow(value.ball().x() - truth.ball().x(), 2) + std::pow(value.ball().y() - truth.ball().y(), 2);
      ++count;
    }
    EXPECT_GT(count, 300);
    return std::sqrt(sum / count);
  }

  const tests::TemporaryFolder folder;
  bool two_sensors = false;
  Truths known;  // without noise, with the names of the robots
};

TEST_F(SmoothedGame, RecordedRobotsAreNamedAndNoOther) {
  record(60, {{"14/2", 0.35}, {"5/2", -2}});
  for (const auto& [value, capture_ns] : read("watched"))
    for (const auto& robot : value.robots()) ASSERT_FALSE(robot.has_player());
  const auto smoothed = smooth({folder / "14-2", folder / "5-2"});
  ASSERT_TRUE(smoothed) << smoothed.error();
  std::size_t named = 0;
  for (const auto& [value, capture_ns] : read("smoothed"))
    for (const auto& robot : value.robots()) {
      if (!robot.has_player()) continue;
      ++named;
      for (const auto& truth : truth_at(capture_ns).robots()) {
        const bool same = truth.team() == robot.team() && truth.player() == robot.player();
        EXPECT_TRUE(!same || std::hypot(robot.x() - truth.x(), robot.y() - truth.y()) < 0.15) << robot.team();
      }
    }
  EXPECT_GT(named, 2 * 0.95 * static_cast<double>(known.size()));
  EXPECT_EQ(smoothed->robots.at(0).moments + smoothed->robots.at(1).moments, named);
  const std::string text = to_text(*smoothed);
  EXPECT_NE(text.find("14/2      in "), std::string::npos) << text;
  EXPECT_NE(text.find("clock 0.3"), std::string::npos) << text;
}

TEST_F(SmoothedGame, PlacesAreBetterThanLiveOnesAndAllElseIsCopied) {
  record(15, {});
  const auto smoothed = smooth({});
  ASSERT_TRUE(smoothed) << smoothed.error();
  EXPECT_EQ(smoothed->images, known.size());
  EXPECT_LT(ball_error("smoothed"), 0.8 * ball_error("watched"));
  const auto original = *logging::open_session(folder / "watched"), copy = *logging::open_session(folder / "smoothed");
  ASSERT_EQ(copy.streams.size(), original.streams.size());
  const auto images = [](const logging::Session& session) {
    return logging::read_all<foresight::TruthSensor>(session, "/truth/1/sensor").size();
  };
  EXPECT_EQ(images(copy), images(original));
  EXPECT_NE(copy.info.about.find("copy of watched with smoothed ground truth"), std::string::npos) << copy.info.about;
}

TEST_F(SmoothedGame, ImagesOfTwoSensorsAtOneMomentGiveOneTruth) {
  two_sensors = true;
  record(3, {});
  const auto smoothed = smooth({});
  ASSERT_TRUE(smoothed) << smoothed.error();
  EXPECT_EQ(smoothed->sensors, 2u);
  EXPECT_EQ(smoothed->images, 2 * known.size());
  const Truths truths = read("smoothed");
  ASSERT_EQ(truths.size(), known.size());
  EXPECT_EQ(truths.at(30).value.robots(0).sensors(), 2u);
}

TEST_F(SmoothedGame, ImagesFromBeforeTheLastCalibrationAreLeftOutAndCounted) {
  record(5, {}, 40);
  const auto smoothed = smooth({});
  ASSERT_TRUE(smoothed) << smoothed.error();
  EXPECT_EQ(smoothed->left_out, 40u);
  EXPECT_EQ(smoothed->moments, known.size() - 40);
  EXPECT_NE(to_text(*smoothed).find("left out  40 images"), std::string::npos);
}

TEST_F(SmoothedGame, ARobotWhoseClockIsNotKnownIsNotUsedAndTheReasonIsSaid) {
  record(5, {{"14/2", 0.35}});
  const auto smoothed = smooth({folder / "14-2"});
  ASSERT_TRUE(smoothed) << smoothed.error();
  EXPECT_EQ(smoothed->robots.at(0).moments, 0u);
  EXPECT_TRUE(smoothed->robots.at(0).refused.starts_with("its clock's offset is not known: "))
      << smoothed->robots.at(0).refused;
}

TEST_F(SmoothedGame, WrongInputIsRefusedAndNothingIsWritten) {
  record(5, {{"14/2", 0}});
  const auto robot = smooth_session({.truth = folder / "14-2", .robots = {}, .session = folder / "smoothed"});
  EXPECT_EQ(robot.error(), "14-2: expected a recording of foresight-lab truth with a calibrated sensor, got none");
  EXPECT_FALSE(smooth({folder / "nowhere"}));
  EXPECT_FALSE(std::filesystem::exists(folder / "smoothed"));
  ASSERT_TRUE(smooth({}));
  EXPECT_FALSE(smooth({})) << "the folder has a session already";
  EXPECT_EQ(read("smoothed").size(), known.size());
}

}  // namespace
}  // namespace robot::app
