// Depth images of a video device, which may be unplugged.
#include "robot/truth/sensor/video_driver.h"

#include <gtest/gtest.h>

#include <functional>
#include <utility>

#include "robot/core/clock.h"
#include "robot/core/little_endian.h"
#include "robot/truth/sensor/live_source.h"
#include "tests/robot/truth/sensor/depth_files.h"
#include "tests/support/fake_video.h"

namespace robot::truth {
namespace {

struct VideoDriverTest : ::testing::Test {
  VideoDriverTest() { camera.format = V4L2_PIX_FMT_Z16; }

  std::unique_ptr<SensorDriver> driver() {
    return video_driver("/dev/video-test", camera.width, camera.height, std::make_unique<tests::FakeVideo>(camera));
  }

  /// Delivers `image`.
  void deliver(std::uint64_t capture_ns) {
    std::string rows;
    for (const std::uint16_t value : image.values) put(rows, value);
    camera.deliver(rows, capture_ns);
  }

  tests::FakeCamera camera{16, 6, 10};  // with padding after each row
  const GreyImage image = tests::grey_image(16, 6);
};

TEST_F(VideoDriverTest, DeliversDepthsWithoutPaddingAtTheKernelsTime) {
  const auto video = driver();
  ASSERT_TRUE(video->open());
  const std::uint64_t now_ns = monotonic_ns(), epoch_ns = system_ns();
  deliver(now_ns / 1000 * 1000);
  const auto frame = video->newest(0);
  ASSERT_TRUE(frame && *frame);
  EXPECT_EQ((*frame)->depth, image.values);
  EXPECT_EQ((*frame)->intrinsics.width, 16);
  EXPECT_EQ((*frame)->intrinsics.height, 6);
  EXPECT_NEAR((*frame)->intrinsics.focal_x, 384.2 * 16 / 640, 1e-9);
  EXPECT_EQ((*frame)->unit, 0.001);
  EXPECT_NEAR(static_cast<double>(static_cast<std::int64_t>((*frame)->capture_ns - epoch_ns)), 0, 1e9);
  EXPECT_FALSE(*video->newest(0));
}

TEST_F(VideoDriverTest, NamesADeviceWithoutDepths) {
  camera.format = V4L2_PIX_FMT_YUYV;
  EXPECT_EQ(driver()->open().error(), "camera /dev/video-test: expected Z16  16x6, got YUYV 16x6");
}

/// A driver that delivers an image as soon as it is open.
class DeliveringDriver final : public SensorDriver {
 public:
  DeliveringDriver(std::unique_ptr<SensorDriver> driver, std::function<void()> deliver)
      : driver_(std::move(driver)), deliver_(std::move(deliver)) {}

  Result<void> open() override {
    Result<void> opened = driver_->open();
    if (opened) deliver_();
    return opened;
  }
  void close() override { driver_->close(); }
  Result<std::optional<DepthFrame>> newest(int patience_ms) override { return driver_->newest(patience_ms); }

 private:
  std::unique_ptr<SensorDriver> driver_;
  std::function<void()> deliver_;
};

TEST_F(VideoDriverTest, ComesBackAfterItWasUnplugged) {
  std::uint64_t now_ns = 0;
  LiveSource source("v4l2:X", std::make_unique<DeliveringDriver>(driver(), [this] { deliver(kSecond); }), {},
                    {.now_ns = [&] { return now_ns; }, .rest_until = [&](std::uint64_t time_ns) { now_ns = time_ns; }});
  for (int round = 0; round < 3; ++round) {
    camera.plug(true);
    const auto frame = source.next();
    ASSERT_TRUE(frame && *frame);
    EXPECT_EQ((*frame)->depth, image.values);
    camera.plug(false);
    EXPECT_EQ(source.next().error(), "v4l2:X: camera /dev/video-test is gone: No such device");
    EXPECT_EQ(source.next().error(),
              "v4l2:X: camera /dev/video-test: expected a video device, got No such file or directory");
  }
  EXPECT_EQ(camera.opened, 3);
}

}  // namespace
}  // namespace robot::truth
