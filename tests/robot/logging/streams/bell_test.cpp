#include "robot/logging/streams/bell.h"

#include <gtest/gtest.h>

#include <atomic>

#include "tests/support/eventually.h"

namespace robot::logging {
namespace {

struct CountingSleeper final : Sleeper {
  void ring(std::uint64_t now_ns) override {
    EXPECT_GE(now_ns, last_ns);
    last_ns = now_ns;
    ++rings;
  }
  bool rung(int times) {
    return tests::eventually([&] { return rings >= times; });
  }

  std::uint64_t last_ns = 0;  // used only by the bell's thread
  std::atomic<int> rings = 0;
};

TEST(Bell, RingsForAllItsSleepersAgainAndAgain) {
  CountingSleeper first, second;
  Bell bell;
  bell.add(first);
  bell.add(second);
  EXPECT_TRUE(first.rung(3));
  EXPECT_TRUE(second.rung(3));
  bell.remove(first);
  const int rings = first.rings;
  EXPECT_TRUE(second.rung(second.rings + 3));
  EXPECT_EQ(first.rings, rings) << "no ring follows a removal";
  bell.remove(second);
}

TEST(Bell, RestsWithoutSleepersAndStartsAgain) {
  Bell bell;
  for (int i = 0; i < 3; ++i) {
    CountingSleeper sleeper;
    bell.add(sleeper);
    EXPECT_TRUE(sleeper.rung(1));
    bell.remove(sleeper);
  }
}

}  // namespace
}  // namespace robot::logging
