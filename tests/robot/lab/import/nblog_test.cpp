#include "robot/lab/import/nblog.h"

#include <gtest/gtest.h>

#include <cmath>

#include "proto/foresight/camera.pb.h"
#include "proto/foresight/sensors.pb.h"
#include "robot/core/files.h"
#include "robot/lab/import/nblog_header.h"
#include "tests/support/nblog_writer.h"
#include "tests/support/real_data.h"
#include "tests/support/recording_sink.h"

namespace robot::lab {
namespace {

namespace pb = foresight;
using tests::NblogWriter;
using tests::RecordingSink;

const std::vector<float> kInertial{1, 2, -58.8f, -2400, -2450, 0, 0.1f, -0.2f, 0};

std::vector<float> twenty_six_angles() {
  std::vector<float> angles(26);
  for (std::size_t i = 0; i < 26; ++i) angles[i] = static_cast<float>(i) / 10;
  return angles;
}

std::string small_log(std::string_view inertial_values = "(acc_x 1.0) (angle_x 0.1)") {
  NblogWriter writer;
  writer.block("YUVImage", "camera_TOP", 1000, "(width 4) (height 2) (encoding \"[Y8(U8/V8)]\")", "0123456789abcdef");
  writer.block("InertialState", "robot", 1000, inertial_values, tests::float_fields(kInertial));
  writer.block("JointAngles", "robot", 2000, "", tests::float_fields(twenty_six_angles()));
  return writer.file();
}

TEST(Nblog, PassesEachBlockOnWithItsTime) {
  RecordingSink sink;
  const auto report = import_nblog(small_log(), 7, sink);
  ASSERT_TRUE(report) << report.error();
  EXPECT_EQ(report->damage, "");
  EXPECT_EQ(report->warnings, std::vector<std::string>());
  ASSERT_EQ(sink.entries.size(), 3u);
  EXPECT_EQ(sink.entries[0].object, "camera_top");
  EXPECT_EQ(sink.entries[0].capture_ns, 1'000'007u);
  EXPECT_EQ(sink.entries[2].capture_ns, 2'000'007u);
  EXPECT_EQ(sink.of<pb::Image>("camera_top")[0]->data(), "0123456789abcdef");
}

TEST(Nblog, TurnsInertialValuesIntoSiUnitsAndLeavesTheGyroscopeOut) {
  RecordingSink sink;
  ASSERT_TRUE(import_nblog(small_log(), 0, sink));
  const auto& inertial = *sink.of<pb::Inertial>("inertial").at(0);
  EXPECT_NEAR(inertial.accelerometer_z(), 9.806, 1e-3);
  EXPECT_LT(inertial.accelerometer_x(), 0);
  EXPECT_FLOAT_EQ(inertial.torso_roll(), 0.1f);
  EXPECT_FLOAT_EQ(inertial.torso_pitch(), -0.2f);
  EXPECT_FALSE(inertial.has_gyroscope_x() || inertial.has_gyroscope_y());
}

TEST(Nblog, PutsJointsIntoOurOrder) {
  RecordingSink sink;
  ASSERT_TRUE(import_nblog(small_log(), 0, sink));
  const auto& joints = *sink.of<pb::Joints>("joints").at(0);
  ASSERT_EQ(joints.position_size(), 25);
  EXPECT_FLOAT_EQ(joints.position(0), 0);      // head yaw
  EXPECT_FLOAT_EQ(joints.position(7), 1.4f);   // left hip yaw pitch
  EXPECT_FLOAT_EQ(joints.position(12), 2.0f);  // left ankle roll
  EXPECT_FLOAT_EQ(joints.position(13), 2.1f);  // right hip roll
  EXPECT_FLOAT_EQ(joints.position(18), 0.8f);  // right shoulder pitch
  EXPECT_FLOAT_EQ(joints.position(23), 0.7f);  // left hand
  EXPECT_FLOAT_EQ(joints.position(24), 1.3f);  // right hand
}

TEST(Nblog, SaysWhereHeaderAndPayloadDisagree) {
  RecordingSink sink;
  const auto report = import_nblog(small_log("(acc_x 1.5)"), 0, sink);
  ASSERT_TRUE(report);
  EXPECT_EQ(report->warnings,
            std::vector<std::string>{"the header says acc_x 1.500000, the payload 1.000000; the payload is taken"});
}

TEST(Nblog, ABlockLargerThanThePayloadIsDamageWhateverItsSize) {
  for (const std::string size : {"4", "1e19", "111111111111111111111111111111111111111111111116"}) {
    NblogWriter writer;
    writer.block("JointAngles) (nbytes " + size, "robot", 1, "", "xyz");  // the first size counts
    RecordingSink sink;
    const auto report = import_nblog(writer.file(), 0, sink);
    ASSERT_TRUE(report);
    EXPECT_EQ(report->damage, "block JointAngles: expected " + size + " bytes, the payload has 3 more");
  }
}

TEST(Nblog, LeavesOutUnknownBlocks) {
  NblogWriter writer;
  writer.block("SonarState", "robot", 1, "", "xyz");
  writer.block("JointAngles", "robot", 2, "", tests::float_fields(twenty_six_angles()));
  RecordingSink sink;
  const auto report = import_nblog(writer.file(), 0, sink);
  ASSERT_TRUE(report);
  EXPECT_EQ(report->warnings, std::vector<std::string>{"a block of type SonarState is left out"});
  EXPECT_EQ(sink.entries.size(), 1u);
}

TEST(Nblog, RefusesOtherVersionsAndOtherFiles) {
  RecordingSink sink;
  std::string file = small_log();
  file.replace(file.find("version 7"), 9, "version 6");
  EXPECT_FALSE(import_nblog(file, 0, sink));
  EXPECT_FALSE(import_nblog("", 0, sink));
  EXPECT_FALSE(import_nblog(std::string(100, 'x'), 0, sink));
  EXPECT_TRUE(sink.entries.empty());
}

TEST(Nblog, EndsWithTheErrorOfTheSink) {
  tests::FullSink sink;
  const auto report = import_nblog(small_log(), 0, sink);
  ASSERT_FALSE(report);
  EXPECT_EQ(report.error(), "disk full");
}

TEST(Nblog, EveryTruncationGivesTheBlocksBeforeItAndNamesTheDamage) {
  const std::string file = small_log();
  RecordingSink whole;
  ASSERT_TRUE(import_nblog(file, 0, whole));
  const std::size_t payload = file.find("0123456789abcdef");
  for (std::size_t size = 0; size < file.size(); ++size) {
    RecordingSink sink;
    const auto report = import_nblog(std::string_view(file).substr(0, size), 0, sink);
    EXPECT_EQ(static_cast<bool>(report), size >= payload - 4) << size;
    EXPECT_TRUE(!report || !report->damage.empty()) << size;
    EXPECT_TRUE(tests::is_start_of(sink.entries, whole.entries)) << size;
    EXPECT_EQ(sink.entries.empty(), size < payload + 16) << size;
  }
}

TEST(Nblog, SurvivesEveryFlippedByte) {
  const std::string file = small_log();
  for (std::size_t i = 0; i < file.size(); ++i) {
    for (const int mask : {0xff, 0x80, 0x01}) {
      std::string flipped = file;
      flipped[i] = static_cast<char>(flipped[i] ^ mask);
      RecordingSink sink;
      const auto report = import_nblog(flipped, 0, sink);
      const bool silent = report && report->damage.empty() && report->warnings.empty();
      EXPECT_TRUE(!silent || sink.entries.size() == 3) << "byte " << i;
    }
  }
}

TEST(NblogHeader, ReadsNestedListsAndQuotedAtoms) {
  const auto parsed = nblog::parse_expression(" (a (b 1.5) (c \"two words\") (d (e f)))");
  ASSERT_TRUE(parsed);
  EXPECT_EQ(parsed->number("b"), 1.5);
  EXPECT_EQ(parsed->find("c")->atom, "two words");
  EXPECT_EQ(parsed->find("d")->items.size(), 2u);
  EXPECT_EQ(parsed->number("c"), std::nullopt);
  EXPECT_EQ(parsed->find("absent"), nullptr);
}

TEST(NblogHeader, NamesTheProblemAndItsPlace) {
  const auto error = [](std::string_view text) { return nblog::parse_expression(text).error(); };
  EXPECT_EQ(error(""), "at character 0: expected more text");
  EXPECT_EQ(error("(a (b)"), "at character 6: a list is never closed");
  EXPECT_EQ(error("(a))"), "at character 3: expected the end of the text");
  EXPECT_EQ(error("(\"a)"), "at character 1: a quotation mark is never closed");
  EXPECT_EQ(error(std::string(100000, '(')), "at character 16: lists are nested too deep");
}

TEST(NblogRecording, ContainsOneMomentOfAV4) {
  REAL_DATA_OR_SKIP(path, "nblog/testLog2.nblog");
  const Result<std::string> bytes = read_file(path, 1 << 22);
  ASSERT_TRUE(bytes);
  RecordingSink sink;
  const auto report = import_nblog(*bytes, 0, sink);
  ASSERT_TRUE(report) << report.error();
  EXPECT_EQ(report->damage, "");
  EXPECT_EQ(report->warnings, std::vector<std::string>{"a block of type CalibrationParams is left out"})
      << "header and payload agree about all values";
  for (const auto& entry : sink.entries) EXPECT_EQ(entry.capture_ns, 41'380'000'000u) << entry.object;

  const auto& image = *sink.of<pb::Image>("camera_top").at(0);
  EXPECT_EQ(image.width(), 640u);
  EXPECT_EQ(image.data().size(), 614'400u);
  const auto& inertial = *sink.of<pb::Inertial>("inertial").at(0);
  EXPECT_NEAR(inertial.accelerometer_z(), 9.81, 1.1);
  const auto& joints = *sink.of<pb::Joints>("joints").at(0);
  EXPECT_FLOAT_EQ(joints.position(1), 0.3159620761871338f);
  // standing with bent knees on flat feet: pitches of hip, knee and ankle cancel in either leg
  EXPECT_NEAR(joints.position(9) + joints.position(10) + joints.position(11), 0, 0.01);
  EXPECT_NEAR(joints.position(14) + joints.position(15) + joints.position(16), 0, 0.01);
}

}  // namespace
}  // namespace robot::lab
