#include "robot/lab/import/bhuman2009.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <set>

#include "proto/foresight/camera.pb.h"
#include "proto/foresight/motion.pb.h"
#include "proto/foresight/sensors.pb.h"
#include "robot/core/files.h"
#include "tests/support/bhuman2009_writer.h"
#include "tests/support/real_data.h"
#include "tests/support/recording_sink.h"

namespace robot::lab {
namespace {

namespace pb = foresight;
using tests::Bhuman2009Writer;
using tests::RecordingSink;

constexpr double kDegree = std::numbers::pi / 180;

Bhuman2009Writer::Motion motion_at(std::uint32_t time_ms) {
  Bhuman2009Writer::Motion motion{.time_ms = time_ms};
  motion.sensors = {-13.5f, -9.5f, 1000,  -0.1f, 0.2f,  -1,    0.75f, 1.28f, 0.28f,
                    0.1f,   0.28f, 0.28f, 0.28f, 0.28f, 0.28f, 400,   0.1f,  -0.2f};
  return motion;
}

/// Two frames of motion with one of cognition between.
std::string small_file() {
  Bhuman2009Writer writer;
  writer.motion(motion_at(1000));
  writer.cognition({.time_ms = 1010});
  writer.motion(motion_at(1020));
  return writer.file();
}

template <class T>
T only(const Bhuman2009Writer& writer, std::string_view object) {
  RecordingSink sink;
  const auto report = import_bhuman2009(writer.file(), 0, sink);
  EXPECT_TRUE(report && report->damage.empty());
  const auto values = sink.of<T>(object);
  EXPECT_EQ(values.size(), 1u) << object;
  return values.empty() ? T() : *values[0];
}

TEST(Bhuman2009, GivesEveryObjectTheTimeOfItsFrame) {
  RecordingSink sink;
  const auto report = import_bhuman2009(small_file(), 5'000'000'000, sink);
  ASSERT_TRUE(report);
  EXPECT_EQ(report->damage, "");
  EXPECT_EQ(report->warnings, std::vector<std::string>());
  const std::map<std::string, std::uint64_t> expected{
      {"battery", 2},  {"camera_bottom", 1}, {"camera_bottom_matrix", 1}, {"fsr", 2}, {"inertial", 2}, {"joints", 2},
      {"odometry", 2}, {"touch", 2}};
  EXPECT_EQ(report->messages, expected);
  for (const auto& entry : sink.entries)
    if (entry.object.starts_with("camera"))
      EXPECT_EQ(entry.capture_ns, 6'010'000'000u);
    else
      EXPECT_TRUE(entry.capture_ns == 6'000'000'000u || entry.capture_ns == 6'020'000'000u) << entry.object;
}

TEST(Bhuman2009, TurnsJointAnglesIntoOurs) {
  Bhuman2009Writer writer;
  auto motion = motion_at(1);
  for (std::size_t i = 0; i < 22; ++i) motion.angles[i] = static_cast<double>(i) * kDegree;
  motion.milliamperes[11] = 1500;  // left hip roll
  motion.celsius[21] = 30;         // right ankle roll
  writer.motion(motion);
  const auto joints = only<pb::Joints>(writer, "joints");
  const double expected_deg[] = {0,  -1, 88, 93, 4,  5,  0,   10, -11, 12, 13, 14, -15,
                                 17, 18, 19, 20, 21, 84, -97, -8, -9,  0,  0,  0};
  ASSERT_EQ(joints.position_size(), 25);
  for (int i = 0; i < 25; ++i) EXPECT_NEAR(joints.position(i), expected_deg[i] * kDegree, 1e-6) << "joint " << i;
  EXPECT_FLOAT_EQ(joints.current(8), 1.5f);
  EXPECT_FLOAT_EQ(joints.temperature(17), 30);
}

TEST(Bhuman2009, TurnsSensorsIntoSiUnitsAndOurSigns) {
  Bhuman2009Writer writer;
  auto motion = motion_at(1);
  motion.sonar_pair = 3;
  motion.keys = {0, 1, 0, 0, 1};
  motion.odometry = {3.5, 1500, -20};
  writer.motion(motion);
  const auto inertial = only<pb::Inertial>(writer, "inertial");
  EXPECT_NEAR(inertial.accelerometer_x(), 0.981, 1e-5);
  EXPECT_NEAR(inertial.accelerometer_y(), -1.962, 1e-5);
  EXPECT_NEAR(inertial.accelerometer_z(), 9.81, 1e-5);
  EXPECT_FLOAT_EQ(inertial.torso_roll(), 0.1f);
  EXPECT_FLOAT_EQ(inertial.torso_pitch(), -0.2f);
  EXPECT_EQ(inertial.gyroscope_x(), 0) << "a constant gyroscope is at its zero";
  EXPECT_FALSE(inertial.has_gyroscope_z());

  const auto fsr = only<pb::Fsr>(writer, "fsr");
  EXPECT_NEAR(fsr.left_front_left(), 1, 1e-6);
  EXPECT_EQ(fsr.left_rear_left(), 0) << "never negative";
  EXPECT_FLOAT_EQ(only<pb::Battery>(writer, "battery").charge(), 0.75f);
  const auto sonar = only<pb::Sonar>(writer, "sonar");
  EXPECT_FALSE(sonar.has_left());
  EXPECT_FLOAT_EQ(sonar.right(), 0.4f);

  const auto touch = only<pb::Touch>(writer, "touch");
  EXPECT_TRUE(touch.chest_button() && touch.right_foot_left());
  EXPECT_FALSE(touch.right_foot_right() || touch.left_foot_right() || touch.left_foot_left());
  const auto odometry = only<pb::Odometry>(writer, "odometry");
  EXPECT_FLOAT_EQ(odometry.x(), 1.5f);
  EXPECT_FLOAT_EQ(odometry.y(), -0.02f);
  EXPECT_NEAR(odometry.heading(), 3.5 - 2 * std::numbers::pi, 1e-6);
}

TEST(Bhuman2009, SubtractsTheMedianOfTheGyroscope) {
  Bhuman2009Writer writer;
  for (const float x : {-13.0f, -13.5f, -12.0f}) {
    auto motion = motion_at(1);
    motion.sensors[0] = x;
    writer.motion(motion);
  }
  RecordingSink sink;
  ASSERT_TRUE(import_bhuman2009(writer.file(), 0, sink));
  const auto inertial = sink.of<pb::Inertial>("inertial");
  EXPECT_FLOAT_EQ(inertial[0]->gyroscope_x(), 0);
  EXPECT_FLOAT_EQ(inertial[1]->gyroscope_x(), -0.5);
  EXPECT_FLOAT_EQ(inertial[2]->gyroscope_x(), 1);
}

TEST(Bhuman2009, DecodesImagesAndTurnsCameraAxes) {
  Bhuman2009Writer writer;
  writer.cognition({.time_ms = 1, .width = 16, .height = 8, .y = 100, .u = 90, .v = 200, .tilt = 0.7});
  const auto image = only<pb::Image>(writer, "camera_bottom");
  EXPECT_EQ(image.width(), 16u);
  EXPECT_EQ(image.height(), 8u);
  ASSERT_EQ(image.data().size(), 2u * 16 * 8);
  for (std::size_t i = 0; i < image.data().size(); ++i)
    EXPECT_NEAR(static_cast<unsigned char>(image.data()[i]), i % 2 == 0 ? 100 : i % 4 == 1 ? 90 : 200, 2) << i;

  const auto matrix = only<pb::CameraMatrix>(writer, "camera_bottom_matrix");
  const double c = std::cos(0.7), s = std::sin(0.7);
  const double expected[] = {0, -s, c, -1, 0, 0, 0, -c, -s};
  ASSERT_EQ(matrix.rotation_size(), 9);
  for (int i = 0; i < 9; ++i) EXPECT_NEAR(matrix.rotation(i), expected[i], 1e-6) << i;
  EXPECT_FLOAT_EQ(matrix.x(), 0.05f);
  EXPECT_FLOAT_EQ(matrix.z(), 0.45f);
  EXPECT_FLOAT_EQ(matrix.focal_x(), 385.54f);
  EXPECT_FLOAT_EQ(matrix.centre_x(), 8);
}

TEST(Bhuman2009, CountsDoubtfulMatricesAndUnknownMessages) {
  Bhuman2009Writer writer;
  writer.cognition({.time_ms = 1, .valid = false});
  writer.message(99, "anything");
  RecordingSink sink;
  const auto report = import_bhuman2009(writer.file(), 0, sink);
  ASSERT_TRUE(report);
  EXPECT_EQ(report->damage, "");
  EXPECT_EQ(report->warnings.size(), 2u);
}

TEST(Bhuman2009, EndsWithTheErrorOfTheSink) {
  tests::FullSink sink;
  const auto report = import_bhuman2009(small_file(), 0, sink);
  ASSERT_FALSE(report);
  EXPECT_EQ(report.error(), "disk full");
}

TEST(Bhuman2009, EveryTruncationGivesTheMessagesBeforeItAndNamesTheDamage) {
  const std::string file = small_file();
  RecordingSink whole;
  ASSERT_TRUE(import_bhuman2009(file, 0, whole));
  for (std::size_t size = 0; size < file.size(); ++size) {
    RecordingSink sink;
    const auto report = import_bhuman2009(std::string_view(file).substr(0, size), 0, sink);
    ASSERT_EQ(static_cast<bool>(report), size >= 8) << size;
    if (!report) continue;
    EXPECT_NE(report->damage, "") << size;
    // an incomplete frame has fewer objects, and its joints may lack the motors, which come later
    std::erase_if(sink.entries, [&](const auto& entry) { return entry.object == "joints"; });
    RecordingSink same = whole;
    std::erase_if(same.entries, [&](const auto& entry) { return entry.object == "joints"; });
    std::size_t found = 0;
    for (const auto& entry : same.entries)
      if (found < sink.entries.size() && entry.object == sink.entries[found].object &&
          entry.capture_ns == sink.entries[found].capture_ns)
        ++found;
    EXPECT_EQ(found, sink.entries.size()) << size;
  }
}

TEST(Bhuman2009, SurvivesEveryFlippedByte) {
  const std::string file = small_file();
  RecordingSink whole;
  ASSERT_TRUE(import_bhuman2009(file, 0, whole));
  for (std::size_t i = 0; i < file.size(); ++i) {
    std::string flipped = file;
    flipped[i] = static_cast<char>(~flipped[i]);
    RecordingSink sink;
    const auto report = import_bhuman2009(flipped, 0, sink);
    ASSERT_TRUE(report) << i;
    EXPECT_TRUE(!report->damage.empty() || !report->warnings.empty() || sink.entries.size() + 2 >= whole.entries.size())
        << "byte " << i;
  }
}

TEST(Bhuman2009, NamesTheMessageThatIsCutOff) {
  const std::string file = small_file();
  RecordingSink sink;
  const auto report = import_bhuman2009(std::string_view(file).substr(0, 20), 0, sink);
  ASSERT_TRUE(report);
  EXPECT_EQ(report->damage, "message 1 at byte 13: expected 180 bytes, the file has 3 more");
}

// --- the real recording ---

struct RealLog {
  RecordingSink sink;
  ImportReport report;
};

const RealLog& real_log(const std::filesystem::path& path) {
  static const RealLog log = [&] {
    RealLog read;
    const Result<std::string> bytes = read_file(path, 1 << 24);
    if (bytes) read.report = import_bhuman2009(*bytes, 0, read.sink).value();
    return read;
  }();
  return log;
}

/// Returns the point where the ray of pixel (u, v) reaches the height `z` above ground.
std::array<double, 2> on_ground(const pb::CameraMatrix& camera, double u, double v, double z) {
  const double q[] = {(u - camera.centre_x()) / camera.focal_x(), (v - camera.centre_y()) / camera.focal_y(), 1};
  double ray[3];
  for (int row = 0; row < 3; ++row)
    ray[row] = camera.rotation(3 * row) * q[0] + camera.rotation(3 * row + 1) * q[1] + camera.rotation(3 * row + 2);
  const double scale = (z - camera.z()) / ray[2];
  return {camera.x() + scale * ray[0], camera.y() + scale * ray[1]};
}

struct Blob {
  double u = 0, v = 0;
  int width = 0, pixels = 0;
};

/// Finds the orange pixels of an image, above the robot's own red chest at its lower edge.
Blob orange(const pb::Image& image) {
  Blob blob;
  int left = 1000, right = 0;
  for (std::size_t pair = 0; pair < image.data().size() / 4; ++pair) {
    const auto cb = static_cast<unsigned char>(image.data()[4 * pair + 1]);
    const auto cr = static_cast<unsigned char>(image.data()[4 * pair + 3]);
    const std::size_t row = 2 * pair / image.width();
    if (cr < 155 || cb > 112 || row > 200) continue;
    const int u = static_cast<int>(2 * pair % image.width());
    blob.u += 2 * (u + 1);
    blob.v += 2 * (static_cast<double>(row) + 0.5);
    left = std::min(left, u);
    right = std::max(right, u + 2);
    blob.pixels += 2;
  }
  blob.u /= std::max(blob.pixels, 1);
  blob.v /= std::max(blob.pixels, 1);
  blob.width = std::max(0, right - left);
  return blob;
}

TEST(Bhuman2009Recording, HasTheKnownNumberOfMessages) {
  REAL_DATA_OR_SKIP(path, "bhuman2009/logfile.log");
  const RealLog& log = real_log(path);
  EXPECT_EQ(log.report.damage, "");
  EXPECT_EQ(log.report.messages.at("inertial"), 273u) << "one of 274 is invalid";
  for (const char* object : {"joints", "fsr", "battery", "touch", "odometry"})
    EXPECT_EQ(log.report.messages.at(object), 274u) << object;
  for (const char* object : {"camera_bottom", "camera_bottom_matrix"})
    EXPECT_EQ(log.report.messages.at(object), 160u) << object;
  const auto [first, last] = std::minmax_element(log.sink.entries.begin(), log.sink.entries.end(),
                                                 [](auto& a, auto& b) { return a.capture_ns < b.capture_ns; });
  EXPECT_NEAR(static_cast<double>(last->capture_ns - first->capture_ns) * 1e-9, 33.3, 0.1);
}

TEST(Bhuman2009Recording, HasPlausibleSensors) {
  REAL_DATA_OR_SKIP(path, "bhuman2009/logfile.log");
  const RealLog& log = real_log(path);
  double gravity = 0;
  for (const auto* inertial : log.sink.of<pb::Inertial>("inertial")) {
    gravity += std::hypot(inertial->accelerometer_x(), inertial->accelerometer_y(), inertial->accelerometer_z()) / 273;
    EXPECT_LT(std::abs(inertial->torso_roll()), 0.45);
    EXPECT_LT(std::abs(inertial->torso_pitch()), 0.3);
    EXPECT_LT(std::hypot(inertial->gyroscope_x(), inertial->gyroscope_y()), 3);
  }
  EXPECT_NEAR(gravity, 9.81, 0.3);
  for (const auto* battery : log.sink.of<pb::Battery>("battery")) EXPECT_NEAR(battery->charge(), 0.975, 0.01);
  const auto odometry = log.sink.of<pb::Odometry>("odometry");
  EXPECT_NEAR(odometry.back()->x() - odometry.front()->x(), 1.53, 0.02);
  EXPECT_NEAR(odometry.back()->y() - odometry.front()->y(), 0.05, 0.02);
  const auto touches = log.sink.of<pb::Touch>("touch");
  EXPECT_EQ(std::count_if(touches.begin(), touches.end(), [](auto* touch) { return touch->chest_button(); }), 8);
}

// These laws hold only if the signs and the order of all joints and sensors are right.
TEST(Bhuman2009Recording, LeaningOnOneFootAgreesWithGravityAndTheLeg) {
  REAL_DATA_OR_SKIP(path, "bhuman2009/logfile.log");
  const RealLog& log = real_log(path);
  std::map<std::string, const google::protobuf::Message*> frame;  // of one time, by object
  double gravity_y = 0, expected_y = 0, left_load = 0, right_load = 0;
  int leaning = 0;
  for (const auto& entry : log.sink.entries) {
    frame[entry.object] = entry.value.get();
    if (entry.object != "fsr") continue;  // the last one of the three
    const auto& inertial = dynamic_cast<const pb::Inertial&>(*frame.at("inertial"));
    const auto& joints = dynamic_cast<const pb::Joints&>(*frame.at("joints"));
    const auto& fsr = dynamic_cast<const pb::Fsr&>(*entry.value);
    const double roll = inertial.torso_roll();
    if (roll > -0.25) continue;  // during the kick the robot leans left by up to 20 degrees
    ++leaning;
    gravity_y += inertial.accelerometer_y();
    expected_y += 9.81 * std::sin(roll);
    left_load += fsr.left_front_left() + fsr.left_front_right() + fsr.left_rear_left() + fsr.left_rear_right();
    right_load += fsr.right_front_left() + fsr.right_front_right() + fsr.right_rear_left() + fsr.right_rear_right();
    EXPECT_NEAR(roll + joints.position(8) + joints.position(12), 0, 0.15) << "the left sole is level";
  }
  ASSERT_GT(leaning, 15);
  EXPECT_NEAR(gravity_y / leaning, expected_y / leaning, 0.5);
  EXPECT_NEAR(left_load / leaning, 5, 1);
  EXPECT_LT(right_load / leaning, 0.2) << "the right foot is in the air";
}

TEST(Bhuman2009Recording, HasTheLowerCameraAtTheKnownHeight) {
  REAL_DATA_OR_SKIP(path, "bhuman2009/logfile.log");
  const RealLog& log = real_log(path);
  std::map<std::uint64_t, double> head_pitch;
  for (const auto& entry : log.sink.entries)
    if (entry.object == "joints")
      head_pitch[entry.capture_ns] = dynamic_cast<const pb::Joints&>(*entry.value).position(1);
  double tilt = 0;
  for (const auto& entry : log.sink.entries) {
    if (entry.object != "camera_bottom_matrix") continue;
    const auto& camera = dynamic_cast<const pb::CameraMatrix&>(*entry.value);
    EXPECT_GT(camera.z(), 0.41);
    EXPECT_LT(camera.z(), 0.495);
    const auto joints = head_pitch.upper_bound(entry.capture_ns);
    ASSERT_NE(joints, head_pitch.end());
    tilt += (std::asin(-camera.rotation(8)) - joints->second) / 160;
  }
  EXPECT_NEAR(tilt / kDegree, 40, 2);
}

TEST(Bhuman2009Recording, ShowsTheBallWhereTheCameraMatrixPutsIt) {
  REAL_DATA_OR_SKIP(path, "bhuman2009/logfile.log");
  const RealLog& log = real_log(path);
  const auto images = log.sink.of<pb::Image>("camera_bottom");
  const auto cameras = log.sink.of<pb::CameraMatrix>("camera_bottom_matrix");
  double first = 0, first_width = 0, nearest = 10, nearest_width = 0;
  for (std::size_t i = 0; i < images.size(); ++i) {
    const Blob ball = orange(*images[i]);
    const double round_width = std::sqrt(4 * ball.pixels / std::numbers::pi);
    if (ball.pixels < 100 || ball.v < 40 || std::abs(ball.width / round_width - 1) > 0.15) continue;
    const auto [x, y] = on_ground(*cameras[i], ball.u, ball.v, 0.04);
    const double distance = std::hypot(x, y);
    if (first == 0) first = distance, first_width = round_width;
    if (distance < nearest) nearest = distance, nearest_width = round_width;
  }
  EXPECT_NEAR(first, 1.6, 0.15);
  EXPECT_NEAR(first_width, 20, 3);
  EXPECT_NEAR(nearest, 0.2, 0.06);
  EXPECT_NEAR(nearest_width, 77, 5);
}

}  // namespace
}  // namespace robot::lab
