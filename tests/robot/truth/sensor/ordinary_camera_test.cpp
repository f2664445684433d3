#include "robot/truth/sensor/ordinary_camera.h"

#include <gtest/gtest.h>

#include "robot/core/clock.h"
#include "robot/truth/sensor/live_source.h"
#include "tests/support/fake_video.h"
#include "tests/support/jpeg_pictures.h"

namespace {

using robot::truth::ColourImage;
using robot::truth::LiveSource;
using robot::truth::SensorDriver;
using tests::FakeCamera;

constexpr std::uint64_t kCaptured_ns = 7'000'000'000;  // by the kernel's clock

/// A camera that takes its next picture as soon as somebody waits for one.
class ReadyVideo final : public robot::nao::VideoDevice {
 public:
  ReadyVideo(FakeCamera& camera, const std::string& frame) : camera_(camera), video_(camera), frame_(frame) {}

  int open(const std::filesystem::path& path) override { return video_.open(path); }
  void close() override { video_.close(); }
  int control(unsigned long request, void* argument) override { return video_.control(request, argument); }
  void* map(std::size_t bytes, std::int64_t offset) override { return video_.map(bytes, offset); }
  void unmap(void* memory, std::size_t bytes) override { video_.unmap(memory, bytes); }
  bool wait(int) override {
    if (!frame_.empty()) camera_.deliver(frame_, kCaptured_ns);
    return video_.wait(0);
  }

 private:
  FakeCamera& camera_;
  tests::FakeVideo video_;
  const std::string& frame_;
};

/// A camera of 48x32 px.
class OrdinaryCamera : public testing::Test {
 protected:
  std::unique_ptr<SensorDriver> driver() {
    return robot::truth::picture_driver("/dev/video7", 48, 32, std::make_unique<ReadyVideo>(device, frame));
  }

  FakeCamera device{48, 32};
  std::string frame = std::string(48 * 32 * 2, '\x80');  // grey
};

TEST_F(OrdinaryCamera, WithoutMjpegDeliversColoursAndNoDepths) {
  const auto camera = driver();
  ASSERT_TRUE(camera->open());
  const auto picture = camera->newest(0);
  ASSERT_TRUE(picture && *picture);
  EXPECT_EQ((*picture)->intrinsics.width, 48);
  EXPECT_EQ((*picture)->intrinsics.height, 32);
  EXPECT_NEAR((*picture)->intrinsics.focal_x, 0.9 * 48, 1e-9);
  EXPECT_EQ((*picture)->intrinsics.baseline, 0);
  EXPECT_EQ((*picture)->rgb, std::vector<std::uint8_t>(48 * 32 * 3, 128));
  EXPECT_TRUE((*picture)->depth.empty());
  const auto late_ns = static_cast<std::int64_t>(robot::system_ns() - (*picture)->capture_ns);
  const auto expected_ns = static_cast<std::int64_t>(robot::monotonic_ns() - kCaptured_ns);
  EXPECT_NEAR(static_cast<double>(late_ns), static_cast<double>(expected_ns), 1e9) << "the kernel's time, to the epoch";
}

TEST_F(OrdinaryCamera, WithMjpegDeliversColours) {
  device.format = V4L2_PIX_FMT_MJPEG;
  ColourImage red{48, 32, std::vector<std::uint8_t>(3 * 48 * 32)};
  for (std::size_t i = 0; i < red.rgb.size(); i += 3) red.rgb[i] = 200;
  frame = tests::jpeg_of(red, 90);
  frame.resize(48 * 32 * 2);  // a driver may leave zeros behind it
  const auto camera = driver();
  ASSERT_TRUE(camera->open());
  const auto picture = camera->newest(0);
  ASSERT_TRUE(picture && *picture);
  EXPECT_NEAR((*picture)->rgb[0], 200, 4);
  EXPECT_NEAR((*picture)->rgb[1], 0, 4);
}

TEST_F(OrdinaryCamera, ADamagedFrameIsLeftOutAndTheNextOneFollows) {
  device.format = V4L2_PIX_FMT_MJPEG;
  const auto camera = driver();
  ASSERT_TRUE(camera->open());
  const auto damaged = camera->newest(0);
  EXPECT_TRUE(damaged && !*damaged);
  frame = tests::jpeg_of({48, 32, std::vector<std::uint8_t>(3 * 48 * 32)}, 90);
  frame.resize(48 * 32 * 2);
  const auto picture = camera->newest(0);
  EXPECT_TRUE(picture && *picture);
  EXPECT_EQ(device.opened, 1);
}

TEST_F(OrdinaryCamera, AnUnpluggedOneComesBackByItself) {
  std::uint64_t now_ns = 0;
  LiveSource source("camera:/dev/video7", driver(), {},
                    {.now_ns = [&] { return now_ns; }, .rest_until = [&](std::uint64_t time_ns) { now_ns = time_ns; }});
  device.plug(false);
  EXPECT_EQ(source.next().error(),
            "camera:/dev/video7: camera /dev/video7: expected a video device, got No such file or directory");
  EXPECT_FALSE(source.next());
  device.plug(true);
  ASSERT_TRUE(source.next());
  device.plug(false);
  EXPECT_EQ(source.next().error(), "camera:/dev/video7: camera /dev/video7 is gone: No such device");
  device.plug(true);
  EXPECT_TRUE(source.next());
}

TEST_F(OrdinaryCamera, OfAnotherSizeIsRefused) {
  FakeCamera small(32, 32);
  const auto other = robot::truth::picture_driver("/dev/video7", 48, 32, std::make_unique<ReadyVideo>(small, frame));
  EXPECT_EQ(other->open().error(), "camera /dev/video7: expected YUYV 48x32, got YUYV 32x32");
}

}  // namespace
