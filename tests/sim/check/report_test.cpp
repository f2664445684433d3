#include "sim/check/report.h"

#include <gtest/gtest.h>

#include "robot/core/json_library.h"

namespace sim::check {
namespace {

/// Two metrics of one situation: one has no value, the other one these.
struct Example {
  explicit Example(int yes) {
    scenario.name = "two.json";
    scenario.metrics = {
        {.name = "touch", .text = "our touch", .metric = parse_metric("our touch").value(), .at_least = 0.6},
        {.name = "when", .text = "time of our goal", .metric = parse_metric("time of our goal").value()}};
    std::vector<double> values(100, 0);
    std::fill_n(values.begin(), yes, 1);
    checked.push_back({&scenario, {judge(scenario.metrics[0], values), judge(scenario.metrics[1], {})}});
  }

  Scenario scenario;
  std::vector<Checked> checked;
};

TEST(CheckReport, IsATableWithIntervals) {
  const std::string text = to_text(Example(40).checked);
  EXPECT_EQ(text,
            "situation  metric  games  mean  95 %            expected      verdict\n"
            "two.json   touch   100    0.4   0.309 .. 0.498  at least 0.6  FAILED\n"
            "two.json   when    0      none\n"
            "\n"
            "0 passed, 0 unsure, 1 failed\n");
  EXPECT_FALSE(all_passed(Example(40).checked));
  EXPECT_TRUE(all_passed(Example(55).checked));  // unsure
  EXPECT_TRUE(all_passed(Example(70).checked));
}

TEST(CheckReport, AsJsonHasTheSameFigures) {
  const Example example(40);
  const auto json = to_json(example.checked);
  EXPECT_EQ(json["passed"], false);
  const auto& metrics = json["situations"][0]["metrics"];
  EXPECT_EQ(metrics[0]["name"], "touch");
  EXPECT_EQ(metrics[0]["mean"], 0.4);
  EXPECT_EQ(metrics[0]["at_least"], 0.6);
  EXPECT_EQ(metrics[0]["verdict"], "failed");
  EXPECT_TRUE(metrics[1]["mean"].is_null());
  EXPECT_EQ(metrics[1]["games"], 0);
}

}  // namespace
}  // namespace sim::check
