#include "sim/check/scenario.h"

#include <gtest/gtest.h>

#include <fstream>

#include "tests/support/temporary_folder.h"

namespace sim::check {
namespace {

/// Writes a situation with that "check" and returns its path.
std::string written(const tests::TemporaryFolder& folder, const std::string& name, const std::string& check) {
  const std::string path = (folder / name).string();
  std::ofstream(path) << R"({"about": "a ball before us", "ball": {"x": 1, "y": 0},
    "robots": [{"side": "home", "player": 2, "x": 0.5, "y": 0}])"
                      << (check.empty() ? "" : R"(, "check": )" + check) << "}";
  return path;
}

std::string refusal(const std::string& check) {
  const tests::TemporaryFolder folder;
  const std::string path = written(folder, "it.json", check);
  const auto scenario = load_scenario(path, {});
  if (scenario) return "accepted";
  const std::string called = "situation '" + path + "': ";
  EXPECT_EQ(scenario.error().find(called), 0u) << scenario.error();
  return scenario.error().substr(std::min(called.size(), scenario.error().size()));
}

TEST(Scenario, AnEventNamesATeamOfTheSituation) {
  const tests::TemporaryFolder folder;
  const std::string path = (folder.path() / "it.json").string();
  std::ofstream(path) << R"({"teams": {"home": 14, "away": 5}, "ball": {"x": 1, "y": 0}, "robots": [],
    "check": {"metrics": {"touch": "our touch"}, "events": ["at 5 s: penalise 5/3"]}})";
  const auto scenario = load_scenario(path, {});
  ASSERT_TRUE(scenario) << scenario.error();
  ASSERT_EQ(scenario->events.size(), 1u);
  EXPECT_EQ(scenario->events[0].robot, robot_of(Side::away, 3));
}

TEST(Scenario, EqualsItsDescription) {
  const tests::TemporaryFolder folder;
  const auto scenario = load_scenario(written(folder, "it.json", R"({
    "home": "kick_now", "seconds": 12, "seeds": 30, "events": ["at 8 s: ball at 1, 0", "at 5 s: penalise home/2"],
    "metrics": {"touch": "our touch", "when": "time of our touch"},
    "expect": {"touch": {"at_least": 0.5, "at_most": 0.9}}})"),
                                      {});
  ASSERT_TRUE(scenario) << scenario.error();
  EXPECT_EQ(scenario->name, "it.json");
  EXPECT_EQ(scenario->about, "a ball before us");
  EXPECT_EQ(scenario->game.strategies[0], "kick_now");
  EXPECT_EQ(scenario->game.strategies[1], "baseline");
  EXPECT_EQ(scenario->seconds, 12);
  EXPECT_EQ(scenario->seeds, 30);
  ASSERT_EQ(scenario->events.size(), 2u);
  EXPECT_EQ(scenario->events[0].at, ticks(5));  // by time
  ASSERT_EQ(scenario->metrics.size(), 2u);
  EXPECT_EQ(scenario->metrics[0].at_least, 0.5);
  EXPECT_EQ(scenario->metrics[0].at_most, 0.9);
  EXPECT_FALSE(scenario->metrics[1].at_least);
}

TEST(Scenario, TheCommandLineReplacesBehavioursAndSeeds) {
  const tests::TemporaryFolder folder;
  const std::string path = written(folder, "it.json", R"({"home": "kick_now", "metrics": {"touch": "our touch"}})");
  const auto scenario = load_scenario(path, {.home = "passing", .away = "idle", .seeds = 7});
  ASSERT_TRUE(scenario) << scenario.error();
  EXPECT_EQ(scenario->game.strategies[0], "passing");
  EXPECT_EQ(scenario->game.strategies[1], "idle");
  EXPECT_EQ(scenario->seeds, 7);
}

TEST(Scenario, AFolderGivesItsFilesByName) {
  const tests::TemporaryFolder folder;
  for (const char* name : {"b.json", "a.json"}) written(folder, name, R"({"metrics": {"touch": "our touch"}})");
  std::ofstream(folder / "notes.txt") << "not a situation";
  const auto scenarios = load_scenarios(folder.path().string(), {});
  ASSERT_TRUE(scenarios) << scenarios.error();
  ASSERT_EQ(scenarios->size(), 2u);
  EXPECT_EQ(scenarios->front().name, "a.json");
  const tests::TemporaryFolder empty;
  EXPECT_EQ(load_scenarios(empty.path().string(), {}).error(),
            "folder '" + empty.path().string() + "': expected situations, files that end in .json, there are none");
}

TEST(Scenario, NamesTheError) {
  EXPECT_EQ(refusal(""), "check is missing, expected an object with the metrics of this situation");
  EXPECT_EQ(refusal("[]"), "check must be an object, got []");
  EXPECT_EQ(refusal("{}"), "check.metrics is missing");
  EXPECT_EQ(refusal(R"({"metrics": {}})"), "check.metrics must have 1 .. 64 entries, got 0");
  EXPECT_EQ(refusal(R"({"metrics": {"a": 1}})"), "check.metrics.a must be a text, got 1");
  EXPECT_EQ(refusal(R"({"metrics": {"a": "our tuch"}})"),
            "check.metrics.a: expected a happening or a quantity, got \"our tuch\"; did you mean 'our touch'?");
  EXPECT_EQ(refusal(R"({"metrics": {"abc": "our touch"}, "expect": {"abd": {"at_least": 1}}})"),
            "check.expect.abd names no metric; did you mean 'abc'?");
  EXPECT_EQ(refusal(R"({"metrics": {"a": "our touch"}, "expect": {"a": {}}})"),
            "check.expect.a must have at_least or at_most");
  EXPECT_EQ(refusal(R"({"metrics": {"a": "our touch"}, "expect": {"a": {"at_least": "x"}}})"),
            "check.expect.a.at_least must be a number, got \"x\"");
  EXPECT_EQ(refusal(R"({"metrics": {"a": "our touch"}, "seed": 1})"), "check.seed is unknown; did you mean 'seeds'?");
  EXPECT_EQ(refusal(R"({"metrics": {"a": "our touch"}, "seconds": 0})"), "check.seconds must be 0.1 .. 3600, got 0");
  EXPECT_EQ(refusal(R"({"metrics": {"a": "our touch"}, "events": ["at 5 s: penalise home/7"]})"),
            "check.events[0]: penalise: expected home/N or away/N, N from 1 to 4, got 'home/7'");
  EXPECT_EQ(refusal(R"({"metrics": {"a": "our touch"}, "home": "basline"})"),
            "no strategy 'basline'; did you mean 'baseline'?");
}

}  // namespace
}  // namespace sim::check
