#include "robot/body/sim/pacer.h"

#include <gtest/gtest.h>

#include <cstdint>

#include "robot/core/clock.h"

namespace robot::body {
namespace {

constexpr std::uint64_t kStart = 1'000 * kSecond;

TEST(Pacer, TicksComeThirtyTimesASecondWithoutDrift) {
  for (const double speed : {0.1, 0.3, 1.0, 2.0, 7.7, 100.0}) {
    Pacer pacer;
    pacer.restart(speed, kStart);
    std::uint64_t due = 0;
    // the thread takes each tick late, as real threads do
    for (int tick = 0; tick < 30'000; ++tick) due = pacer.take(pacer.next_ns() + 60'000);
    const double seconds = static_cast<double>(due - kStart) * 1e-9;
    EXPECT_NEAR(seconds, 1000 / speed, 1e-6) << speed;
    EXPECT_EQ(pacer.ticks_behind(), 0u) << speed;
  }
}

TEST(Pacer, AGameThatIsALittleBehindCatchesUp) {
  Pacer pacer;
  pacer.restart(1, kStart);
  const std::uint64_t late = kStart + Pacer::kPatienceNs;
  int ticks = 0;
  for (; pacer.next_ns() <= late; ++ticks) pacer.take(late);
  EXPECT_EQ(ticks, 3);
  EXPECT_EQ(pacer.ticks_behind(), 0u);
}

TEST(Pacer, AGameThatIsFarBehindGivesUpAllButAFewTicksAndCountsThem) {
  for (const double speed : {0.1, 1.0, 10.0, 100.0}) {
    Pacer pacer;
    pacer.restart(speed, kStart);
    const std::uint64_t late = kStart + 60 * kSecond;
    std::uint64_t ticks = 0, last = 0;
    for (; pacer.next_ns() <= late; ++ticks) {
      const std::uint64_t due = pacer.take(late);
      EXPECT_GT(due, last) << "due times never go back";
      EXPECT_LE(due, late);
      EXPECT_GE(static_cast<double>(due), static_cast<double>(late - Pacer::kPatienceNs) - 1e9 / (30 * speed) - 10'000);
      last = due;
    }
    const double asked = 60 * 30 * speed;
    EXPECT_NEAR(static_cast<double>(ticks + pacer.ticks_behind()), asked, 1) << speed;
    EXPECT_LE(static_cast<double>(ticks), 0.1 * 30 * speed + 2) << speed;
  }
}

TEST(Pacer, AnotherSpeedBeginsNowAndForgetsNoLoss) {
  Pacer pacer;
  pacer.restart(1, kStart);
  pacer.take(kStart + kSecond);
  const std::uint64_t behind = pacer.ticks_behind();
  EXPECT_GT(behind, 20u);
  pacer.restart(10, kStart + 5 * kSecond);
  EXPECT_EQ(pacer.next_ns(), kStart + 5 * kSecond + kSecond / 300);
  EXPECT_EQ(pacer.ticks_behind(), behind);
  EXPECT_EQ(pacer.speed(), 10);
}

}  // namespace
}  // namespace robot::body
