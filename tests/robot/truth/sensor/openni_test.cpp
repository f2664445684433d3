// OpenNI's own stand-in for a sensor: its driver "Dummy" delivers 320x240 depths, 30 a second.
#include <gtest/gtest.h>

#include "robot/core/clock.h"
#include "robot/truth/sensor/kinect.h"
#include "robot/truth/sensor/open_source.h"

namespace robot::truth {
namespace {

TEST(Openni, DeliversTheImagesOfADevice) {
  const auto source = open_source("openni:Dummy");
  ASSERT_TRUE(source) << source.error();
  std::uint64_t last_ns = system_ns() - kSecond;
  for (int i = 0; i < 3; ++i) {
    const auto frame = (*source)->next();
    ASSERT_TRUE(frame) << frame.error();
    ASSERT_TRUE(*frame);
    EXPECT_EQ((*frame)->intrinsics, kinect_intrinsics(320, 240)) << "it reports no field of view";
    EXPECT_EQ((*frame)->unit, 0.001);
    EXPECT_EQ((*frame)->depth.size(), 320u * 240);
    EXPECT_GT((*frame)->capture_ns, last_ns);
    last_ns = (*frame)->capture_ns;
  }
  EXPECT_LE(last_ns, system_ns() + kSecond);
}

TEST(Openni, OpensADeviceAgain) {
  for (int i = 0; i < 3; ++i) {
    const auto source = open_source("openni:Dummy");
    ASSERT_TRUE(source);
    const auto frame = (*source)->next();
    ASSERT_TRUE(frame && *frame);
  }
}

TEST(Openni, NamesAnAbsentSensor) {
  EXPECT_EQ((*open_source("openni:17"))->next().error().find("openni:17: expected a sensor with the number 17, found "),
            0u);
  EXPECT_EQ((*open_source("openni:/none.oni"))->next().error(),
            "openni:/none.oni: the sensor does not open: DeviceOpen: Couldn't open device '/none.oni'");
}

}  // namespace
}  // namespace robot::truth
