// Fits to the labelled video of a real half: figures that are fitted to the truth alone.
#include <gtest/gtest.h>

#include <algorithm>

#include "robot/core/files.h"
#include "robot/fit/falling/falling.h"
#include "robot/fit/opponents/opponents.h"
#include "robot/fit/rebounds/rebounds.h"
#include "robot/lab/import/session_sink.h"
#include "robot/lab/import/spl_labels.h"
#include "robot/logging/sessions/session_writer.h"
#include "sim/io/matchup.h"
#include "tests/support/real_data.h"
#include "tests/support/temporary_folder.h"

namespace {

/// Writes the truth of a label file to a new session.
robot::Result<void> import_half(const std::filesystem::path& file, const std::filesystem::path& session) {
  const auto bytes = robot::read_file(file, 10'000'000);
  if (!bytes) return bytes.failure();
  return robot::logging::write_session(
      session, {.robot = "0/1"}, [&](robot::logging::SessionWriter& writer) -> robot::Result<void> {
        robot::lab::SessionSink sink("0/1", writer);
        const auto report = robot::lab::import_spl_labels(*bytes, 1'000'000'000'000'000'000, sink);
        if (!report) return report.failure();
        return {};
      });
}

void expect_between(const robot::fit::Report& report, const std::string& name, double low, double high) {
  const auto found = std::ranges::find(report.figures, name, &robot::fit::Figure::name);
  ASSERT_NE(found, report.figures.end()) << name;
  EXPECT_GT(found->value, low) << name;
  EXPECT_LT(found->value, high) << name;
  EXPECT_LT(found->low, found->value) << name;
  EXPECT_GT(found->high, found->value) << name;
}

TEST(RealHalf, FallsSpeedsAndKicksAreThoseOfRealRobots) {
  REAL_DATA_OR_SKIP(path, "spl_labels/B-Human__2019-07-07_13-30-00_B-Human_vs_Nao-Team_HTWK_half1-A.csv");
  const tests::TemporaryFolder folder;
  const auto written = import_half(path, folder / "half");
  ASSERT_TRUE(written) << written.error();
  const auto evidence = robot::fit::gather({}, {folder / "half"}, 1'000'000'000);
  ASSERT_TRUE(evidence) << evidence.error();
  const auto game = sim::io::prepare({.rules = "spl2025"});
  ASSERT_TRUE(game) << game.error();
  const sim::Models& models = game->params.teams[0].models;
  const robot::fit::Report falls = fit_falling(*evidence, models);
  expect_between(falls, "falls.per_minute_walking", 0.1, 1.5);
  expect_between(falls, "falls.per_second_touching", 0.001, 0.2);
  const robot::fit::Report opponents = fit_opponents(*evidence, models);
  expect_between(opponents, "opponents.speed", 0.25, 0.42);
  expect_between(opponents, "opponents.speed_median", 0.1, 0.2);
  expect_between(opponents, "opponents.kick_speed", 0.5, 1.5);
  EXPECT_TRUE(fit_rebounds(*evidence, models).empty()) << "a half has too few rebounds";
}

}  // namespace
