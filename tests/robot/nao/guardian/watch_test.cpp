#include "robot/nao/guardian/watch.h"

#include <gtest/gtest.h>

#include "tests/support/fake_body.h"

namespace robot::nao {
namespace {

struct NaoWatch : ::testing::Test {
  tests::FakeBody body;
  Watch watch;
  std::uint64_t now_ns = 0;

  void see(float seconds = 0) {
    do watch.see(body.sensors, now_ns += tests::kCycle_ns);
    while ((seconds -= 0.012f) > 0);
  }
};

TEST_F(NaoWatch, FindsAHealthyRobotHealthy) {
  see(2);
  EXPECT_TRUE(watch.upright() && watch.upright_lasts() && watch.on_feet());
  EXPECT_FALSE(watch.falls() || watch.warm() || watch.hot() || watch.battery_low() || watch.battery_empty());
}

TEST_F(NaoWatch, DetectsAFallToAnySide) {
  for (const std::size_t axis : {0u, 1u})
    for (const float sign : {-1.0f, 1.0f}) {
      body.put_upright();
      body.sensors.angles[axis] = sign * 0.6f;
      see();
      EXPECT_FALSE(watch.falls());
      EXPECT_FALSE(watch.upright());
      body.sensors.gyroscope[axis] = sign * 3;
      see();
      EXPECT_TRUE(watch.falls()) << "it will have fallen soon";
      body.sensors.gyroscope[axis] = -sign * 3;
      see();
      EXPECT_FALSE(watch.falls()) << "it swings back";
      body.sensors.gyroscope[axis] = 0;
      body.sensors.angles[axis] = sign * 0.7f;
      see();
      EXPECT_TRUE(watch.falls());
    }
}

TEST_F(NaoWatch, AShakeIsNoFall) {
  body.sensors.gyroscope = {5, -5, 5};
  see(1);
  EXPECT_FALSE(watch.falls());
}

TEST_F(NaoWatch, ReportsLastingHeatWithHysteresis) {
  body.sensors.temperature[r_knee_pitch] = 71;
  see(0.3f);
  EXPECT_FALSE(watch.warm()) << "not yet";
  see(0.6f);
  EXPECT_TRUE(watch.warm());
  body.sensors.temperature[r_knee_pitch] = 67;
  see(1);
  EXPECT_TRUE(watch.warm()) << "not cool yet";
  body.sensors.temperature[r_knee_pitch] = 77;
  see(1);
  EXPECT_TRUE(watch.hot());
  body.sensors.temperature[r_knee_pitch] = 69;
  see(1);
  EXPECT_TRUE(watch.hot());
  body.sensors.temperature[r_knee_pitch] = 65;
  see(1);
  EXPECT_FALSE(watch.hot() || watch.warm());
}

TEST_F(NaoWatch, ReportsALowBatteryUnlessItIsCharged) {
  body.sensors.battery[0] = 0.08f;
  see(1);
  EXPECT_TRUE(watch.battery_low());
  EXPECT_FALSE(watch.battery_empty());
  body.sensors.battery[0] = 0.04f;
  see(1);
  EXPECT_TRUE(watch.battery_empty());
  body.sensors.battery[0] = 0.06f;
  see(1);
  EXPECT_TRUE(watch.battery_empty()) << "until it is well above";
  body.sensors.battery[1] = -32552;  // recorded from a robot on its charger
  see(1);
  EXPECT_FALSE(watch.battery_empty() || watch.battery_low());
}

TEST_F(NaoWatch, IsStillOnlyAfterHalfASecondWithoutATurn) {
  see(0.4f);
  EXPECT_FALSE(watch.still());
  see(0.2f);
  EXPECT_TRUE(watch.still());
  body.sensors.gyroscope = {0, 0, -0.4f};
  see();
  EXPECT_FALSE(watch.still()) << "at once";
  body.sensors.gyroscope = {0, 0, -0.2f};
  see(0.4f);
  EXPECT_FALSE(watch.still());
  see(0.2f);
  EXPECT_TRUE(watch.still());
}

TEST_F(NaoWatch, DetectsWhetherItStandsOnItsFeet) {
  body.lift();
  see();
  EXPECT_FALSE(watch.on_feet());
  body.sensors.fsr[3] = 1.1f;
  see();
  EXPECT_TRUE(watch.on_feet());
}

}  // namespace
}  // namespace robot::nao
