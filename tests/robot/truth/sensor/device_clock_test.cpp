// A sensor's counter on the computer's clock.
#include "robot/truth/sensor/device_clock.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "robot/core/clock.h"

namespace robot::truth {
namespace {

constexpr std::uint64_t kStart_ns = 1'700'000'000 * kSecond;
constexpr double kFrame = 1.0 / 30;  // [s]

/// A sensor that exposes 30 images a second and whose images arrive late by a varying time.
struct Sensor {
  double crystal = 1;  // its seconds / true seconds
  std::mt19937 random{1};

  std::uint64_t exposed_ns(int image) const {
    return kStart_ns + static_cast<std::uint64_t>(std::llround(image * kFrame * 1e9));
  }
  std::uint64_t ticks(int image) const {
    return static_cast<std::uint64_t>(std::llround(4e9 + image * kFrame * crystal * 60e6)) & 0xffffffff;
  }
  /// At least 10 ms, up to 20 ms later in most images.
  std::uint64_t arrival_ns(int image) { return exposed_ns(image) + 10 * kMillisecond + random() % (20 * kMillisecond); }
};

TEST(DeviceClock, RemovesTheVaryingPartOfTheDelay) {
  Sensor sensor;
  DeviceClock clock(60e6, 32);
  // 300 s; the counter of 32 bits starts again from 0 every 72 s
  for (int image = 0; image < 9000; ++image) {
    const std::uint64_t arrival_ns = sensor.arrival_ns(image);
    const std::uint64_t capture_ns = clock.capture_ns(sensor.ticks(image), arrival_ns);
    ASSERT_LE(capture_ns, arrival_ns);
    if (image < 150) continue;
    const double late = static_cast<double>(static_cast<std::int64_t>(capture_ns - sensor.exposed_ns(image))) / 1e6;
    ASSERT_NEAR(late, 10, 1) << "image " << image;
  }
}

TEST(DeviceClock, FollowsACrystalThatIsWrong) {
  for (const double error : {-50e-6, 50e-6}) {
    Sensor sensor{.crystal = 1 + error};
    DeviceClock clock(60e6, 32);
    for (int image = 0; image < 9000; ++image) {
      const std::uint64_t capture_ns = clock.capture_ns(sensor.ticks(image), sensor.arrival_ns(image));
      if (image < 150) continue;
      const double late = static_cast<double>(static_cast<std::int64_t>(capture_ns - sensor.exposed_ns(image))) / 1e6;
      ASSERT_NEAR(late, 10, 2) << "image " << image;
    }
  }
}

TEST(DeviceClock, LearnsAgainWhenTheCounterStartedAnew) {
  DeviceClock clock(1e6, 64);
  EXPECT_EQ(clock.capture_ns(5'000'000, kStart_ns), kStart_ns);
  EXPECT_EQ(clock.capture_ns(5'033'000, kStart_ns + 40 * kMillisecond), kStart_ns + 33 * kMillisecond);
  // the counter starts from 0
  EXPECT_EQ(clock.capture_ns(0, kStart_ns + 100 * kMillisecond), kStart_ns + 100 * kMillisecond);
  EXPECT_EQ(clock.capture_ns(33'000, kStart_ns + 140 * kMillisecond), kStart_ns + 133 * kMillisecond);
  // the sensor was away for an hour, and its counter stood still
  EXPECT_EQ(clock.capture_ns(66'000, kStart_ns + 3600 * kSecond), kStart_ns + 3600 * kSecond);
  EXPECT_EQ(clock.capture_ns(99'000, kStart_ns + 3600 * kSecond + 40 * kMillisecond),
            kStart_ns + 3600 * kSecond + 33 * kMillisecond);
}

}  // namespace
}  // namespace robot::truth
