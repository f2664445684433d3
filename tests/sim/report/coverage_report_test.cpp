#include "sim/report/coverage_report.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "robot/core/json_library.h"
#include "sim/debug/setup.h"
#include "tests/sim/support/games.h"

namespace sim::report {
namespace {

/// A game of a minute, watched.
struct Watched {
  debug::SharedSetup setup = debug::prepare({}).value();
  debug::Parts parts{debug::tree_of(setup->params, 0)->tree()};
  debug::Coverage coverage;

  Watched() {
    for (std::uint64_t seed = 1; seed <= 2; ++seed) {
      State state = test::begun(setup->params, seed);
      coverage.add(watch_game(setup->params, state, Side::home, parts, ticks(60)));
    }
  }
  CoverageReport report() const { return {.parts = parts, .coverage = coverage, .about = "of <one> side"}; }
};

TEST(CoverageReport, TextJsonAndPageNameEveryPartAndEveryComparisonThatNeverChanges) {
  const Watched watched;
  const CoverageReport report = watched.report();
  const std::string text = to_text(report), page = page_of(report);
  const Json json = to_json(report);
  ASSERT_EQ(json["parts"].size(), watched.parts.all().size());
  for (std::size_t i = 0; i < watched.parts.all().size(); ++i) {
    EXPECT_EQ(json["parts"][i]["decisions"], watched.coverage.parts[i].decisions);
    EXPECT_EQ(json["parts"][i].contains("goals_within_30_s"), watched.coverage.parts[i].decisions > 0);
  }
  const std::vector<std::size_t> never = report.never_reached(), same = report.always_same();
  ASSERT_FALSE(never.empty()) << "a minute reaches not everything";
  ASSERT_FALSE(same.empty());
  for (const std::size_t part : never) {
    EXPECT_EQ(watched.coverage.parts[part].decisions, 0);
    EXPECT_NE(text.find("\n  " + watched.parts.all()[part].path + "\n"), std::string::npos);
  }
  for (const std::size_t node : same)
    EXPECT_NE(text.find(watched.parts.tree().node_words[node].condition), std::string::npos);
  EXPECT_NE(page.find("never reached"), std::string::npos);
  EXPECT_NE(page.find("of &lt;one&gt; side"), std::string::npos) << "texts of others are escaped";
  EXPECT_EQ(page.find("<script"), std::string::npos);
}

TEST(CoverageReport, OfPartsThatAreNeverReachedOnlyTheOutermostIsNamed) {
  const Watched watched;
  const std::vector<std::size_t> never = watched.report().never_reached();
  for (const std::size_t one : never)
    for (const std::size_t other : never)
      EXPECT_FALSE(watched.parts.all()[one].path.starts_with(watched.parts.all()[other].path + "/"));
  for (std::size_t i = 0; i < watched.parts.all().size(); ++i) {
    if (watched.coverage.parts[i].decisions > 0) continue;
    EXPECT_TRUE(std::any_of(never.begin(), never.end(), [&](std::size_t outer) {
      const std::string& path = watched.parts.all()[i].path;
      return path == watched.parts.all()[outer].path || path.starts_with(watched.parts.all()[outer].path + "/");
    })) << watched.parts.all()[i].path;
  }
}

TEST(CoverageReport, TheSharesOfTheTimeAddUp) {
  const Watched watched;
  double sum = 0;
  for (std::size_t i = 0; i < watched.parts.all().size(); ++i)
    if (!watched.parts.all()[i].skill.empty()) sum += watched.report().time_share(i);
  EXPECT_NEAR(sum, 1, 1e-9);
}

}  // namespace
}  // namespace sim::report
