// Whole recordings, checked with the models that simulated them and with others.
#include "robot/fit/checking/checking.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <string>

#include "sim/io/models.h"
#include "tests/support/simulated_robots.h"
#include "tests/support/temporary_folder.h"

namespace robot::fit {
namespace {

constexpr const char* kPlanted = "match,hits.partial=0.3";

sim::Models models_with(const std::string& changes) { return *sim::io::load_models(kPlanted + changes); }

/// A simulated game of 120 s, recorded and read once.
struct CheckedGame {
  ::tests::TemporaryFolder folder;
  Evidence evidence = tests::simulated_robots(folder.path() / "game",
                                              {.models = kPlanted, .seconds = 120, .seed = 1, .place_error = 0.003});
  Situations situations = read_situations(evidence, models_with(""));
};

const CheckedGame& checked_game() {
  static const CheckedGame game;
  return game;
}

/// Returns the names of the statistics that are outside.
std::vector<std::string> outside_in(const Report& report) {
  std::vector<std::string> names;
  for (const Results& results : report.results)
    for (const auto& row : results.rows)
      if (row[4] == "OUTSIDE") names.push_back(row[1]);
  return names;
}

TEST(Checking, ItsOwnModelsHaveAllStatisticsInside) {
  const Report report = check_models(checked_game().situations, models_with(""));
  EXPECT_EQ(report.name, "check");
  ASSERT_EQ(report.results.size(), 1u);
  EXPECT_TRUE(outside_in(report).empty()) << to_text(report);
  const auto& rows = report.results[0].rows;
  EXPECT_GE(rows.size(), 12u);
  for (const auto& row : rows) EXPECT_EQ(row.size(), report.results[0].head.size());
  ASSERT_EQ(report.scores.size(), 2u);
  EXPECT_EQ(report.scores[0], (std::pair<std::string, double>("statistics", static_cast<double>(rows.size()))));
  EXPECT_EQ(report.scores[1], (std::pair<std::string, double>("outside", 0.)));
  EXPECT_TRUE(report.kept.empty());
  EXPECT_TRUE(report.figures.empty());

  // a dot for each row, between the lines
  ASSERT_EQ(report.pictures.size(), 1u);
  const Mark& dots = report.pictures[0].marks.back();
  ASSERT_EQ(dots.y.size(), rows.size());
  for (const double y : dots.y) EXPECT_LE(std::abs(y), 1);
}

TEST(Checking, AFasterWalkIsOutsideByItsSpeed) {
  const std::vector<std::string> names = outside_in(check_models(
      checked_game().situations, models_with(",walk.forward=0.455,walk.backward=0.351,walk.sideward=0.312")));
  EXPECT_FALSE(names.empty());
  for (const std::string& name : names) EXPECT_TRUE(name.starts_with("walk: speed")) << name;
}

TEST(Checking, OtherModelsOfTheRadioAndOfVisionAreOutside) {
  const auto names =
      outside_in(check_models(checked_game().situations, models_with(",radio.loss=0.4,ball_detection.near=0.4")));
  EXPECT_TRUE(std::ranges::find(names, "radio: share of lost packets") != names.end());
  EXPECT_TRUE(std::ranges::find(names, "vision: share of balls seen at 1-2 m") != names.end());
  for (const std::string& name : names) EXPECT_TRUE(name.starts_with("radio") || name.starts_with("vision")) << name;
}

TEST(Checking, TheSameRecordingsGiveTheSame) {
  const sim::Models models = models_with("");
  const Report one = check_models(checked_game().situations, models),
               other = check_models(checked_game().situations, models);
  ASSERT_EQ(one.results.size(), other.results.size());
  EXPECT_EQ(one.results[0].rows, other.results[0].rows);
  EXPECT_EQ(one.notes, other.notes);
}

TEST(Checking, WithoutRobotsOnlyTheTruthIsChecked) {
  Evidence evidence;
  evidence.games = checked_game().evidence.games;
  const Report report = check_models(evidence, models_with(""));
  ASSERT_EQ(report.results.size(), 1u);
  for (const auto& row : report.results[0].rows)
    EXPECT_TRUE(row[1].starts_with("rolling") || row[1] == "falls: number") << row[1];
  EXPECT_FALSE(report.notes.empty());
}

TEST(Checking, NothingRecordedSaysWhy) {
  const Report report = check_models(Evidence{}, models_with(""));
  EXPECT_TRUE(report.results.empty());
  EXPECT_TRUE(report.pictures.empty());
  ASSERT_FALSE(report.notes.empty());
  EXPECT_EQ(report.notes[0],
            "nothing can be checked: expected robots that walk, kick, fall or see the ball beside a truth");
  EXPECT_EQ(report.scores[0].second, 0);
}

}  // namespace
}  // namespace robot::fit
