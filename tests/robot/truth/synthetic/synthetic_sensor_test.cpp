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

TEST(SyntheticSensor, SkipsTheImagesWhoseTimeHasPassed) {
  std::vector<std::uint64_t> asked;
  std::uint64_t now_ns = 0;
  const auto scene_at = [&](std::uint64_t capture_ns) {
    asked.push_back(capture_ns);
    return Scene{};
  };
  SyntheticSensor sensor(mast(kField2012, -1, 0, kSmall), kHall, scene_at,
                         {.rate_hz = 10, .first_capture_ns = 1'000'000'000, .now_ns = [&] { return now_ns; }});
  const auto image_at = [&](std::uint64_t at_ns) {
    now_ns = at_ns;
    ASSERT_TRUE(sensor.next());
  };
  image_at(0);              // before the first image: nothing has passed
  image_at(1'000'000'000);  // in time
  image_at(1'250'000'000);  // late: the image of 1.2 s has passed
  image_at(1'300'000'000);  // it is ahead again
  EXPECT_EQ(asked, (std::vector<std::uint64_t>{1'000'000'000, 1'100'000'000, 1'300'000'000, 1'400'000'000}));
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
