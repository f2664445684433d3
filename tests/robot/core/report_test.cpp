#include "robot/core/report.h"

#include <gtest/gtest.h>

#include <vector>

namespace robot {
namespace {

struct Heard {
  Heard() {
    set_report_listener([this](const Report& report) { reports.push_back(report); });
  }
  ~Heard() { set_report_listener({}); }
  std::vector<Report> reports;
};

TEST(Report, ReachesTheListener) {
  const Heard heard;
  report(Level::warning, "camera", "/dev/video-top: expected 30 frames a second, got 12");
  ASSERT_EQ(heard.reports.size(), 1u);
  EXPECT_EQ(heard.reports[0].level, Level::warning);
  EXPECT_EQ(heard.reports[0].source, "camera");
  EXPECT_EQ(heard.reports[0].sentence, "/dev/video-top: expected 30 frames a second, got 12");
}

TEST(Report, DoesNotReachARemovedListener) {
  std::size_t count = 0;
  set_report_listener([&](const Report&) { ++count; });
  set_report_listener({});
  report(Level::info, "test", "nobody hears this");
  EXPECT_EQ(count, 0u);
}

TEST(Throttle, LetsOneASecondThroughAndCountsTheOthers) {
  const Heard heard;
  Throttle throttle;
  for (std::uint64_t i = 0; i < 1000; ++i) throttle.report(Level::error, "net", "bad packet", kSecond + i);
  EXPECT_EQ(heard.reports.size(), 1u);
  throttle.report(Level::error, "net", "bad packet", 2 * kSecond);
  ASSERT_EQ(heard.reports.size(), 2u);
  EXPECT_EQ(heard.reports[1].sentence, "bad packet (and 999 more like it)");
}

}  // namespace
}  // namespace robot
