#include "robot/truth/tags/picture_camera.h"

#include <gtest/gtest.h>

#include "tests/support/fake_video.h"
#include "tests/support/jpeg_pictures.h"

namespace {

using robot::SessionClock;
using robot::truth::tags::black_picture;
using robot::truth::tags::Picture;
using robot::truth::tags::PictureCamera;
using tests::FakeCamera;

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
    if (!frame_.empty()) camera_.deliver(frame_, 7'000'000'000);
    return video_.wait(0);
  }

 private:
  FakeCamera& camera_;
  tests::FakeVideo video_;
  const std::string& frame_;
};

/// A camera of 48x32 px that is opened again at once.
class PictureCameraTest : public testing::Test {
 protected:
  FakeCamera device{48, 32};
  std::string frame = std::string(48 * 32 * 2, '\x80');  // grey
  const SessionClock clock{1000};
  PictureCamera camera{"/dev/video7", {48, 32}, std::make_unique<ReadyVideo>(device, frame), clock, 1};
};

TEST_F(PictureCameraTest, APictureOfACameraWithoutMjpeg) {
  const auto picture = camera.next();
  ASSERT_TRUE(picture) << picture.error();
  ASSERT_TRUE(*picture);
  EXPECT_EQ((*picture)->size, (robot::truth::tags::PictureSize{48, 32}));
  EXPECT_EQ((*picture)->rgb, std::vector<std::uint8_t>(48 * 32 * 3, 128));
  EXPECT_EQ((*picture)->capture_ns, 7'000'001'000u);
  EXPECT_EQ(camera.address(), "camera:/dev/video7");
  EXPECT_TRUE(camera.live());
}

TEST_F(PictureCameraTest, APictureOfACameraWithMjpeg) {
  device.format = V4L2_PIX_FMT_MJPEG;
  Picture red = black_picture({48, 32});
  for (std::size_t i = 0; i < red.rgb.size(); i += 3) red.rgb[i] = 200;
  frame = tests::jpeg_of(red, 90);
  frame.resize(48 * 32 * 2);  // a driver may leave zeros behind it
  const auto picture = camera.next();
  ASSERT_TRUE(picture) << picture.error();
  ASSERT_TRUE(*picture);
  EXPECT_NEAR((*picture)->rgb[0], 200, 4);
  EXPECT_NEAR((*picture)->rgb[1], 0, 4);
}

TEST_F(PictureCameraTest, ADamagedFrameIsAnErrorAndTheNextOneFollows) {
  device.format = V4L2_PIX_FMT_MJPEG;
  EXPECT_TRUE(camera.next().error().starts_with("camera:/dev/video7: JPEG: "));
  frame = tests::jpeg_of(black_picture({48, 32}), 90);
  frame.resize(48 * 32 * 2);
  const auto picture = camera.next();
  EXPECT_TRUE(picture && *picture);
  EXPECT_EQ(device.opened, 1);
}

TEST_F(PictureCameraTest, AnUnpluggedCameraComesBackByItself) {
  device.plug(false);
  EXPECT_EQ(camera.next().error(), "camera /dev/video7: expected a video device, got No such file or directory");
  EXPECT_FALSE(camera.next());
  device.plug(true);
  ASSERT_TRUE(camera.next());
  device.plug(false);
  EXPECT_EQ(camera.next().error(), "camera /dev/video7 is gone: No such device");
  device.plug(true);
  EXPECT_TRUE(camera.next());
}

TEST_F(PictureCameraTest, ASilentCameraIsAnErrorAndIsOpenedAgain) {
  frame.clear();
  EXPECT_EQ(camera.next().error(), "camera /dev/video7 sends no pictures");
  EXPECT_FALSE(camera.next());
  EXPECT_EQ(device.opened, 4);  // each time for MJPEG and for YUYV
}

TEST_F(PictureCameraTest, ACameraOfAnotherSizeIsRefused) {
  FakeCamera small(32, 32);
  PictureCamera other("/dev/video7", {48, 32}, std::make_unique<ReadyVideo>(small, frame), clock, 1);
  EXPECT_EQ(other.next().error(), "camera /dev/video7: expected YUYV 48x32, got YUYV 32x32");
}

}  // namespace
