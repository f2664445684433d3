#include "robot/fit/figure.h"

#include <gtest/gtest.h>

#include "robot/fit/text_plot.h"

namespace robot::fit {
namespace {

TEST(Figure, ASentenceHasAllOfIt) {
  const Figure figure{.name = "ball.deceleration",
                      .unit = "m/s²",
                      .value = 0.30211,
                      .low = 0.295,
                      .high = 0.309,
                      .events = 41,
                      .kind = "free rolls",
                      .recordings = {"a", "b"},
                      .domain = {.quantity = "speed", .unit = "m/s", .from = 0.25, .to = 2.1}};
  EXPECT_EQ(to_text(figure),
            "0.3021 m/s² (95 %: 0.295 .. 0.309), 41 free rolls of 2 recordings, speed 0.25 .. 2.10 m/s");
}

TEST(Table, IsCsvWithQuotedTexts) {
  const Table table{.columns = {"time [s]", "a \"b\""},
                    .names = {"one", "two, three"},
                    .rows = {{.recording = 1, .values = {0.1, -2}}, {.recording = 0, .values = {1e-5, 3}}}};
  EXPECT_EQ(to_csv(table), "recording,\"time [s]\",\"a \"\"b\"\"\"\r\n\"two, three\",0.1,-2\r\n\"one\",1e-05,3\r\n");
}

TEST(TextPlot, CornersAreAtTheEndsOfTheAxes) {
  TextPlot plot({.left = 0, .right = 10, .bottom = 1, .top = 2});
  plot.dot('a', 0, 2);
  plot.dot('b', 10, 1);
  plot.dot('c', 11, 1.5);
  plot.dot('c', 5, NAN);
  const std::string text = plot.text();
  EXPECT_EQ(text.find("   2.00 |a\n"), 0u) << text;
  EXPECT_NE(text.find("   1.00 |" + std::string(TextPlot::kWidth - 1, ' ') + "b\n"), std::string::npos) << text;
  EXPECT_EQ(text.find('c'), std::string::npos) << "outside, or no number";
}

TEST(TextPlot, AnEmptyRangeIsNoError) {
  TextPlot plot({.left = 3, .right = 3, .bottom = 0, .top = 0});
  plot.dot('a', 3, 0);
  EXPECT_NE(plot.text().find('a'), std::string::npos);
}

}  // namespace
}  // namespace robot::fit
