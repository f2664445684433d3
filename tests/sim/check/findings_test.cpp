#include "sim/check/findings.h"

#include <gtest/gtest.h>

#include <fstream>

#include "tests/support/temporary_folder.h"

namespace sim::check {
namespace {

NamedMetric share(std::optional<double> at_least, std::optional<double> at_most = {}) {
  return {.name = "it",
          .text = "our touch",
          .metric = parse_metric("our touch").value(),
          .at_least = at_least,
          .at_most = at_most};
}

std::vector<double> values(int yes, int all) {
  std::vector<double> made(static_cast<std::size_t>(all), 0);
  std::fill_n(made.begin(), yes, 1);
  return made;
}

Verdict verdict(int yes, int all, std::optional<double> at_least, std::optional<double> at_most = {}) {
  return judge(share(at_least, at_most), values(yes, all)).verdict;
}

TEST(Interval, OfAShareHoldsItAndStaysWithinZeroAndOne) {
  for (int all = 1; all < 60; ++all)
    for (int yes = 0; yes <= all; ++yes) {
      const Interval interval = interval_of_share(yes, all);
      const double mean = static_cast<double>(yes) / all;
      EXPECT_GE(interval.low, 0);
      EXPECT_LE(interval.high, 1);
      EXPECT_LE(interval.low, mean);
      EXPECT_GE(interval.high, mean);
      const Interval opposite = interval_of_share(all - yes, all);
      EXPECT_NEAR(interval.low, 1 - opposite.high, 1e-12);
    }
  // Wilson's interval for 55 of 100
  EXPECT_NEAR(interval_of_share(55, 100).low, 0.4524, 1e-4);
  EXPECT_NEAR(interval_of_share(55, 100).high, 0.6439, 1e-4);
}

TEST(Verdict, FailsOnlyIfTheWholeIntervalIsBeyondALimit) {
  EXPECT_EQ(verdict(55, 100, {}), Verdict::none);
  EXPECT_EQ(verdict(55, 100, 0.5), Verdict::passed);
  EXPECT_EQ(verdict(55, 100, 0.6), Verdict::unsure);
  EXPECT_EQ(verdict(55, 100, 0.7), Verdict::failed);
  EXPECT_EQ(verdict(55, 100, {}, 0.5), Verdict::unsure);
  EXPECT_EQ(verdict(55, 100, {}, 0.4), Verdict::failed);
  EXPECT_EQ(verdict(55, 100, 0.5, 0.6), Verdict::passed);
}

TEST(Verdict, AConditionThatMustAlwaysHoldFailsWithTheFirstGameWithoutIt) {
  EXPECT_EQ(verdict(100, 100, 1), Verdict::passed);
  EXPECT_EQ(verdict(99, 100, 1), Verdict::failed);
  EXPECT_EQ(verdict(0, 100, {}, 0), Verdict::passed);
  EXPECT_EQ(verdict(1, 100, {}, 0), Verdict::failed);
}

TEST(Verdict, FailsIfNoGameHasAValue) {
  EXPECT_EQ(judge(share(0.5), {}).verdict, Verdict::failed);
  EXPECT_EQ(judge(share({}), {}).verdict, Verdict::none);
}

/// Loads a situation in which home 2 stands behind the ball and nobody else plays.
Scenario scenario(const std::string& check) {
  const tests::TemporaryFolder folder;
  const std::string path = (folder / "it.json").string();
  std::ofstream(path) << R"({"ball": {"x": 1.8, "y": 0}, "robots": [{"side": "home", "player": 2, "x": 1.3, "y": 0}],
    "check": )" << check
                      << "}";
  auto loaded = load_scenario(path, {});
  EXPECT_TRUE(loaded) << loaded.error();
  return *std::move(loaded);
}

TEST(Play, GivesTheSameFindingsEachTime) {
  const Scenario situation = scenario(R"({"seconds": 15, "seeds": 12, "fuzz": true, "metrics": {
    "touch": "our touch", "when": "time of our touch", "far": "most ball_x"}})");
  const auto one = play(situation), again = play(situation);
  ASSERT_TRUE(one && again);
  ASSERT_EQ(one->size(), 3u);
  for (std::size_t i = 0; i < one->size(); ++i) {
    EXPECT_EQ((*one)[i].mean, (*again)[i].mean);
    EXPECT_EQ((*one)[i].games, (*again)[i].games);
  }
  EXPECT_GT((*one)[0].mean, 0.5);  // it stands behind the ball
  EXPECT_EQ((*one)[0].games, 12);
  EXPECT_LE((*one)[1].games, 12);
}

TEST(Play, EventsHappen) {
  const Scenario situation = scenario(R"({"seconds": 10, "seeds": 4, "home": "idle",
    "events": ["at 2 s: ball at -1, 1", "at 5 s: penalise home/2"],
    "metrics": {"placed": "time of ball_x < 0", "left": "time of our_players < 1", "most": "most our_players"}})");
  const auto findings = play(situation);
  ASSERT_TRUE(findings);
  EXPECT_NEAR((*findings)[0].mean, 2, 0.1);
  EXPECT_NEAR((*findings)[1].mean, 5, 0.1);
  EXPECT_EQ((*findings)[2].mean, 1);
}

}  // namespace
}  // namespace sim::check
