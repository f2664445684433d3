// Sessions of a simulated game with planted offsets between their clocks.
#include "robot/lab/clocks/session_times.h"

#include <gtest/gtest.h>

#include <cstdlib>

#include "robot/core/json_library.h"
#include "robot/lab/clocks/truth_report.h"
#include "tests/support/recorded_truth.h"
#include "tests/support/temporary_folder.h"

namespace robot::lab {
namespace {

struct GameBesideTruth : testing::Test {
  const tests::TemporaryFolder folder;

  void record(tests::RecordedTruthPlan plan) const {
    plan.from = 30;
    tests::record_game(folder.path(), plan);
  }

  SessionTimes times(const std::vector<std::string>& names, std::uint64_t most_ns = 60 * kSecond) const {
    auto found = session_times(sessions(names), most_ns);
    EXPECT_TRUE(found) << found.error();
    return std::move(*found);
  }

  std::vector<logging::Session> sessions(const std::vector<std::string>& names) const {
    std::vector<logging::Session> all;
    for (const std::string& name : names) all.push_back(*logging::open_session(folder / name));
    return all;
  }
};

/// Expects a shift [ns] of `seconds`, within 2 ms.
void expect_shift(const Agreement& agreement, double seconds) {
  EXPECT_NEAR(static_cast<double>(agreement.shift_ns) * 1e-9, seconds, 0.002) << agreement.sentence;
}

TEST_F(GameBesideTruth, PlantedOffsetsOfBothSignsAreCorrectedAndTheSentencesSaySo) {
  record({.seconds = 60, .ahead = {{"14/2", 0.35}, {"5/2", -12.25}}, .change = {}});
  const SessionTimes found = times({"truth", "14-2", "5-2"});
  EXPECT_EQ(found.agreements[0].shift_ns, 0);
  EXPECT_EQ(found.agreements[0].sentence, "");
  expect_shift(found.agreements[1], -0.35);
  expect_shift(found.agreements[2], 12.25);
  EXPECT_TRUE(found.agreements[1].sentence.starts_with("14/2's clock is 0.3")) << found.agreements[1].sentence;
  EXPECT_TRUE(found.agreements[1].sentence.ends_with(
      " of the ground truth's, by the ball, as 14/2 of the truth (by its number): its times are shifted"))
      << found.agreements[1].sentence;
  EXPECT_NE(found.agreements[2].sentence.find(" s behind (± "), std::string::npos);
}

TEST_F(GameBesideTruth, TheFirstSessionKeepsItsTimesAndTheTruthMayBeAnyOfThem) {
  record({.seconds = 60, .ahead = {{"14/2", 0.35}, {"5/2", -2}}, .change = {}});
  const SessionTimes found = times({"14-2", "5-2", "truth"});
  EXPECT_EQ(found.agreements[0].shift_ns, 0);
  expect_shift(found.agreements[1], 2.35);
  expect_shift(found.agreements[2], 0.35);
  EXPECT_NE(found.agreements[1].sentence.find("by the ground truth of both"), std::string::npos);
  EXPECT_TRUE(found.agreements[2].sentence.starts_with("the ground truth's clock is 0.3"));
}

TEST_F(GameBesideTruth, WithoutATruthNothingIsCompared) {
  record({.seconds = 2, .ahead = {{"14/2", 0.35}, {"5/2", -2}}, .change = {}});
  const SessionTimes found = times({"14-2", "5-2"});
  EXPECT_TRUE(found.truth.empty());
  EXPECT_TRUE(found.robots.empty());
  EXPECT_FALSE(found.agreements[1].known);
  EXPECT_EQ(
      found.agreements[1].sentence,
      "the clocks of 5/2 and 14/2 cannot be compared: no clock samples of one machine are in both; their times stay "
      "unchanged");
}

TEST_F(GameBesideTruth, ARecordingThatIsTooShortIsRefusedAndItsTimesStay) {
  record({.seconds = 5, .ahead = {{"14/2", 0.35}}, .change = {}});
  const SessionTimes found = times({"truth", "14-2"});
  EXPECT_EQ(found.agreements[1].shift_ns, 0);
  EXPECT_FALSE(found.agreements[1].known);
  EXPECT_TRUE(found.agreements[1].sentence.starts_with(
      "the clocks of 14/2 and the ground truth cannot be compared: no good clock "
      "samples of one machine are in both, and only "))
      << found.agreements[1].sentence;
  EXPECT_TRUE(found.agreements[1].sentence.ends_with("; their times stay unchanged"));
  const TruthReport report = truth_report(found.truth, found.robots.at(0));
  EXPECT_NE(to_text(report).find("clock    its offset is not known: only "), std::string::npos);
  EXPECT_TRUE(to_json(report)["ball"].contains("refused"));
}

TEST_F(GameBesideTruth, ALargerOffsetThanAllowedIsNotSearchedFor) {
  record({.seconds = 60, .ahead = {{"14/2", 8}}, .change = {}});
  EXPECT_EQ(times({"truth", "14-2"}, kSecond).agreements[1].shift_ns, 0);
}

TEST_F(GameBesideTruth, RobotsWithoutNumbersAreToldApartByThePose) {
  for (const auto change : {&tests::leave_tracks, &tests::leave_places}) {
    const tests::TemporaryFolder other;
    tests::record_game(other.path(), {.from = 30, .seconds = 60, .ahead = {{"5/2", 0.35}}, .change = change});
    const auto found =
        session_times({*logging::open_session(other / "truth"), *logging::open_session(other / "5-2")}, 60 * kSecond);
    ASSERT_TRUE(found) << found.error();
    expect_shift(found->agreements[1], -0.35);
    EXPECT_NE(found->agreements[1].sentence.find("of the truth (by its pose)"), std::string::npos)
        << found->agreements[1].sentence;
  }
}

TEST_F(GameBesideTruth, TheBallBeliefIsComparedAfterTheCorrection) {
  record({.seconds = 60, .ahead = {{"5/2", 0.35}}, .change = {}});
  const SessionTimes found = times({"truth", "5-2"});
  const TruthReport report = truth_report(found.truth, found.robots.at(0));
  ASSERT_TRUE(report.ball) << report.ball.error();
  EXPECT_GT(report.ball->all.distance.samples, 200u);
  EXPECT_LT(report.ball->all.place.median, 0.02) << "robots with perfect models, of the side whose frame is turned";
  EXPECT_LT(report.ball->all.distance.median, 0.02);
  const std::string text = to_text(report);
  EXPECT_TRUE(text.starts_with("5/2 beside the ground truth\nclock    0.3")) << text;
  EXPECT_NE(text.find("\nall "), std::string::npos);
  const auto as_json = to_json(report);
  EXPECT_NEAR(std::atof(as_json["clock"]["offset_ns"].get<std::string>().c_str()), 0.35e9, 2e6);
  EXPECT_EQ(as_json["ball"]["all"]["distance"]["samples"], report.ball->all.distance.samples);
}

}  // namespace
}  // namespace robot::lab
