#include "robot/app/import.h"

#include <gtest/gtest.h>

#include "robot/app/rules_field.h"
#include "robot/core/files.h"
#include "robot/logging/sessions/session.h"
#include "tests/support/bhuman2009_writer.h"
#include "tests/support/label_writer.h"
#include "tests/support/nblog_writer.h"
#include "tests/support/temporary_folder.h"

namespace robot::app {
namespace {

struct Import : testing::Test {
  const tests::TemporaryFolder folder;

  /// Imports the bytes of a file and returns the facts of the session.
  logging::SessionInfo imported(const std::string& format, const std::string& bytes) {
    EXPECT_TRUE(replace_file(folder / "file", bytes));
    const auto report = import_recording(
        {.format = format, .file = folder / "file", .session = folder / format, .robot = {.team = 14, .player = 2}});
    EXPECT_TRUE(report) << report.error();
    const auto session = logging::read_session(folder / format);
    EXPECT_TRUE(session) << session.error();
    return session->info;
  }
};

TEST_F(Import, ARecordingOf2009HasTheRulesAndTheFieldOfItsYearWhichAreAssumed) {
  tests::Bhuman2009Writer writer;
  for (std::uint32_t time_ms = 0; time_ms < 100; time_ms += 10) writer.motion({.time_ms = time_ms});
  const logging::SessionInfo info = imported("bhuman2009", writer.file());
  EXPECT_EQ(info.rules, "spl2012:3");
  EXPECT_FLOAT_EQ(field_of(info.rules).length(), 6);
  EXPECT_EQ(info.about, "assumed: the rules spl2012:3, because the league of 2009 played three a side on 6 x 4 m");
}

TEST_F(Import, ALogOf2014HasTheRulesAndTheFieldOfItsYearWhichAreAssumed) {
  tests::NblogWriter writer;
  writer.block("InertialState", "sensors", 1'000'000, "", tests::float_fields({1, 2, -65, 0, 0, 0, 0, 0, 0}));
  const logging::SessionInfo info = imported("nblog", writer.file());
  EXPECT_EQ(info.rules, "spl2025:5");
  EXPECT_FLOAT_EQ(field_of(info.rules).length(), 9);
  EXPECT_EQ(info.about, "assumed: the rules spl2025:5, because the league of 2014 played five a side on 9 x 6 m");
}

TEST_F(Import, LabelsHaveTheRulesOntoWhoseFieldTheyAreFitted) {
  const logging::SessionInfo info = imported("spl_labels", tests::label_file(tests::label_camera(), 20));
  EXPECT_EQ(info.rules, "spl2025");
  EXPECT_EQ(info.about.find("assumed"), std::string::npos);
}

TEST_F(Import, OnlyARecordingOf2009HasABallToFind) {
  ASSERT_TRUE(replace_file(folder / "file", "time,ball_x,ball_y\n0,1,2\n"));
  const auto report = import_recording({.format = "truth_csv",
                                        .file = folder / "file",
                                        .session = folder / "session",
                                        .robot = {.team = 14, .player = 2},
                                        .find_ball = true});
  ASSERT_FALSE(report);
  EXPECT_NE(report.error().find("--find-ball is for bhuman2009, got the format truth_csv"), std::string::npos)
      << report.error();
}

TEST_F(Import, ARecordingOf2009WithItsBallHasAVisionOfEachPicture) {
  tests::Bhuman2009Writer writer;
  writer.cognition({.time_ms = 10});
  ASSERT_TRUE(replace_file(folder / "file", writer.file()));
  const auto report = import_recording({.format = "bhuman2009",
                                        .file = folder / "file",
                                        .session = folder / "session",
                                        .robot = {.team = 14, .player = 2},
                                        .find_ball = true});
  ASSERT_TRUE(report) << report.error();
  EXPECT_EQ(report->report.messages.at("vision"), 1u);
}

TEST_F(Import, ATableOfPositionsBecomesASessionWithItsDate) {
  const logging::SessionInfo info =
      imported("truth_csv", "time,ball_x,ball_y\n2026-03-14T12:00:00Z,1,2\n2026-03-14T12:00:01Z,3,4\n");
  EXPECT_EQ(info.rules, "");
  EXPECT_EQ(info.start_ns, 1'773'489'600'000'000'000u);
  EXPECT_EQ(logging::read_session(folder / "truth_csv")->end_ns, 1'773'489'601'000'000'000u);
}

TEST_F(Import, AFolderOfItsOwnHasTheDateInItsName) {
  ASSERT_TRUE(replace_file(folder / "a.csv", "time,ball_x,ball_y\n2026-03-14T12:00:00Z,1,2\n"));
  const auto made = import_recording({.format = "auto", .file = folder / "a.csv", .out = folder.path(), .name = "a"});
  ASSERT_TRUE(made) << made.error();
  EXPECT_EQ(made->session.filename().string().substr(0, 10), "2026-03-14");
  EXPECT_TRUE(logging::read_session(made->session));
}

TEST_F(Import, AFileWithoutADateStartsIn2009) {
  EXPECT_EQ(imported("truth_csv", "t,ball_x,ball_y\n5,1,2\n").start_ns, kUndatedEpochNs);
}

}  // namespace
}  // namespace robot::app
