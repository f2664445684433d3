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

}  // namespace
}  // namespace robot::app
