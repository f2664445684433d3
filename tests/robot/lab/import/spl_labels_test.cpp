#include "robot/lab/import/spl_labels.h"

#include <gtest/gtest.h>

#include <cmath>

#include "proto/foresight/truth.pb.h"
#include "robot/core/files.h"
#include "robot/lab/import/label_camera.h"
#include "tests/support/label_writer.h"
#include "tests/support/real_data.h"
#include "tests/support/recording_sink.h"

namespace robot::lab {
namespace {

namespace pb = foresight;
using tests::RecordingSink;

const std::string& known_file() {
  static const std::string file = tests::label_file(tests::label_camera(), 40);
  return file;
}

/// The import of the known file.
const RecordingSink& known_import() {
  static const RecordingSink imported = [] {
    RecordingSink sink;
    const auto report = import_spl_labels(known_file(), 1'000'000'000, sink);
    EXPECT_TRUE(report) << report.error();
    return sink;
  }();
  return imported;
}

const pb::GroundTruth::TrueRobot& robot_of(const pb::GroundTruth& truth, std::uint32_t team, std::uint32_t player) {
  for (const auto& robot : truth.robots())
    if (robot.team() == team && robot.player() == player) return robot;
  ADD_FAILURE() << "no robot " << team << "/" << player;
  return pb::GroundTruth::TrueRobot::default_instance();
}

TEST(SplLabels, AKnownCameraIsFound) {
  const auto rows = labels::read_rows(known_file());
  const auto camera = labels::fit_camera(labels::upright_boxes(rows->frames));
  ASSERT_TRUE(camera) << camera.error();
  EXPECT_FALSE(camera->super_view);
  EXPECT_NEAR(camera->height, 2.6, 0.03);
  EXPECT_NEAR(camera->pitch, 0.45, 0.01);
  EXPECT_NEAR(camera->focal_px, 900, 20);
  EXPECT_LT(labels::error_of(*camera, labels::upright_boxes(rows->frames)).share, 0.002);
}

TEST(SplLabels, PlacesAreThoseOfTheKnownGame) {
  const auto truths = known_import().of<pb::GroundTruth>("/truth/world");
  ASSERT_EQ(truths.size(), 1200u);
  for (const std::size_t frame : {0u, 300u, 777u, 1199u})
    for (const tests::Labelled& one : tests::labelled_game(static_cast<double>(frame) / 30)) {
      const pb::GroundTruth& truth = *truths[frame];
      if (one.number == 0) {
        EXPECT_NEAR(static_cast<double>(truth.ball().x()), one.x, 0.06);
        EXPECT_NEAR(static_cast<double>(truth.ball().y()), one.y, 0.06);
        continue;
      }
      const auto& robot = robot_of(truth, one.colour == 2 ? 1 : 2, static_cast<std::uint32_t>(one.number));
      EXPECT_NEAR(static_cast<double>(robot.x()), one.x, 0.06);
      EXPECT_NEAR(static_cast<double>(robot.y()), one.y, 0.06);
      EXPECT_EQ(robot.fallen(), one.down);
    }
}

TEST(SplLabels, FramesAreAThirtiethOfASecondApart) {
  const auto& entries = known_import().entries;
  EXPECT_EQ(entries.front().capture_ns, 1'000'000'000u);
  EXPECT_EQ(entries[30].capture_ns, 2'000'000'000u);
  EXPECT_EQ(entries.back().capture_ns, 1'000'000'000u + 1199ull * 1'000'000'000 / 30);
}

TEST(SplLabels, TheReportStatesTheErrorOnBothHalves) {
  RecordingSink sink;
  const auto report = import_spl_labels(known_file(), 0, sink);
  ASSERT_TRUE(report);
  EXPECT_EQ(report->damage, "");
  EXPECT_NE(report->about.find("median error 0.0 % of the distance"), std::string::npos) << report->about;
  EXPECT_NE(report->about.find("fitted to one half of the file, 0."), std::string::npos) << report->about;
}

TEST(SplLabels, ATruncatedFileGivesEverythingBefore) {
  RecordingSink sink;
  const auto report = import_spl_labels(std::string_view(known_file()).substr(0, known_file().size() - 9), 0, sink);
  ASSERT_TRUE(report);
  EXPECT_NE(report->damage, "");
  EXPECT_EQ(sink.entries.size(), 1200u);
}

TEST(SplLabels, AFileWithoutGoalkeepersOrWithFewBoxesIsRefused) {
  RecordingSink sink;
  const std::string header = "filename,label,x_min,y_min,x_max,y_max,color,number\n";
  EXPECT_EQ(import_spl_labels(header, 0, sink).error(), "the teams: expected jerseys of two colours, got 0");
  EXPECT_EQ(import_spl_labels(header + "1.jpg,0,10,10,20,40,1,2\n1.jpg,0,10,10,20,40,2,2\n", 0, sink).error(),
            "the camera: expected at least 50 boxes of upright robots, got 2");
  std::string file = known_file();
  for (std::size_t at = file.find(",5,1\n"); at != file.npos; at = file.find(",5,1\n", at))
    file.replace(at, 5, ",5,9\n");
  EXPECT_EQ(import_spl_labels(file, 0, sink).error(),
            "the field: expected at least 50 boxes of the goalkeeper with number 1 and colour 5, got 0");
  EXPECT_TRUE(sink.entries.empty());
}

TEST(SplLabels, EndsWithTheErrorOfTheSink) {
  tests::FullSink sink;
  EXPECT_EQ(import_spl_labels(known_file(), 0, sink).error(), "disk full");
}

}  // namespace
}  // namespace robot::lab
