#include "robot/truth/synthetic/synthetic_sensor.h"

#include <gtest/gtest.h>

#include "tests/robot/truth/synthetic/hall.h"

namespace robot::truth {
namespace {

TEST(SyntheticSensor, AsksForTheSceneOfEachCaptureTime) {
  std::vector<std::uint64_t> asked;
  const auto scene_at = [&](std::uint64_t capture_ns) {
    asked.push_back(capture_ns);
    return Scene{};
  };
  SyntheticSensor sensor(mast(kField2012, -1, 0, kSmall), kHall, scene_at, {.first_capture_ns = 1'000});
  for (int i = 0; i < 4; ++i) {
    const auto frame = sensor.next();
    ASSERT_TRUE(frame) << frame.error();
    ASSERT_TRUE(frame->has_value());
    EXPECT_EQ((*frame)->capture_ns, asked.back());
  }
  EXPECT_EQ(asked, (std::vector<std::uint64_t>{1'000, 33'334'333, 66'667'667, 100'001'000}));
}

TEST(SyntheticSensor, ReturnsTheImageOfTheScene) {
  const SensorPose pose = mast(kField2012, -1, 0, kSmall);
  Scene scene{.robots = {{.x = 0.3}}};
  SyntheticSensor sensor(pose, kHall, [&](std::uint64_t) { return scene; });
  Renderer renderer(pose, kHall);
  for (std::uint64_t number = 0; number < 3; ++number) {
    const auto frame = sensor.next();
    ASSERT_TRUE(frame);
    EXPECT_EQ((*frame)->depth, renderer.render(scene, number).depth);
    EXPECT_EQ((*frame)->intrinsics, kSmall);
  }
}

TEST(SyntheticSensor, HasTheAddressOfItsOptionsAndIsLiveIfItsCallerPacesIt) {
  const auto nothing = [](std::uint64_t) { return Scene{}; };
  const SensorPose pose = mast(kField2012, -1, 0, kSmall);
  const SyntheticSensor usual(pose, kHall, nothing);
  EXPECT_EQ(usual.address(), "synthetic");
  EXPECT_TRUE(usual.live());
  const SyntheticSensor other(pose, kHall, nothing, {.address = "synthetic:2", .live = false});
  EXPECT_EQ(other.address(), "synthetic:2");
  EXPECT_FALSE(other.live());
}

}  // namespace
}  // namespace robot::truth
