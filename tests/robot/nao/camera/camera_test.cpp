// Frames of a fake camera: the newest one, upright, with the driver's time stamp. The camera may vanish and come back.
#include <gtest/gtest.h>

#include <algorithm>
#include <atomic>
#include <cerrno>
#include <functional>
#include <memory>
#include <mutex>

#include "robot/core/files.h"
#include "robot/core/report.h"
#include "robot/memory/memory.h"
#include "robot/nao/camera/camera_thread.h"
#include "tests/support/eventually.h"
#include "tests/support/fake_video.h"
#include "tests/support/real_data.h"

namespace robot::nao {
namespace {

using tests::FakeCamera;
using tests::FakeVideo;

constexpr std::uint64_t kFrame_ns = 33'333'000;

/// Returns a picture whose bytes depend on their position and on `seed`.
std::string picture(std::uint32_t width, std::uint32_t height, int seed) {
  std::string rows;
  for (std::uint32_t i = 0; i < 2 * width * height; ++i)
    rows += static_cast<char>(i * 7 + i / 251 + static_cast<unsigned>(seed));
  return rows;
}

struct NaoCamera : ::testing::Test {
  CameraSettings settings() const {
    return {.device = "/dev/video-test", .width = camera.width, .height = camera.height};
  }
  Result<VideoCapture> open(const CameraSettings& with) { return VideoCapture::open(video, with, warnings); }

  /// Returns the newest image, upright.
  std::string next(VideoCapture& capture, std::uint64_t* capture_ns = nullptr) {
    const auto frame = capture.newest(0);
    if (!frame || !*frame) return "none";
    std::string image;
    capture.copy(**frame, image);
    if (capture_ns) *capture_ns = (*frame)->capture_ns;
    capture.give_back(**frame);
    return image;
  }

  FakeCamera camera{8, 4, 6};  // with padding after each row
  FakeVideo video{camera};
  std::vector<std::string> warnings;
};

TEST_F(NaoCamera, GivesTheNewestFrameAndItsTime) {
  auto capture = open(settings());
  ASSERT_TRUE(capture) << capture.error();
  EXPECT_EQ(next(*capture), "none");
  for (int i = 1; i <= 3; ++i) camera.deliver(picture(8, 4, i), static_cast<std::uint64_t>(i) * kFrame_ns);
  std::uint64_t capture_ns = 0;
  EXPECT_EQ(next(*capture, &capture_ns), picture(8, 4, 3));
  EXPECT_EQ(capture_ns, 3 * kFrame_ns);
  EXPECT_EQ(capture->passed_over(), 2u);
  EXPECT_EQ(next(*capture), "none");
  // all buffers are back at the device
  for (int i = 4; i <= 100; ++i) {
    camera.deliver(picture(8, 4, i), static_cast<std::uint64_t>(i) * kFrame_ns);
    ASSERT_EQ(next(*capture), picture(8, 4, i));
  }
  EXPECT_EQ(camera.lost, 0u);
}

TEST_F(NaoCamera, TurnsImagesOfACameraMountedUpsideDown) {
  CameraSettings turned = settings();
  turned.turned = true;
  auto capture = open(turned);
  ASSERT_TRUE(capture);
  const std::string sent = picture(8, 4, 5);
  camera.deliver(sent, kFrame_ns);
  const std::string got = next(*capture);
  ASSERT_EQ(got.size(), sent.size());
  const auto luma = [](const std::string& image, std::size_t x, std::size_t y) { return image[2 * (8 * y + x)]; };
  const auto colour = [](const std::string& image, std::size_t x, std::size_t y, int which) {
    return image[2 * (8 * y + x / 2 * 2) + 1 + 2 * static_cast<std::size_t>(which)];
  };
  for (std::size_t y = 0; y < 4; ++y)
    for (std::size_t x = 0; x < 8; ++x) {
      EXPECT_EQ(luma(got, x, y), luma(sent, 7 - x, 3 - y));
      for (const int which : {0, 1}) EXPECT_EQ(colour(got, x, y, which), colour(sent, 7 - x, 3 - y, which));
    }
}

TEST_F(NaoCamera, LeavesDamagedFramesOut) {
  auto capture = open(settings());
  ASSERT_TRUE(capture);
  camera.deliver(picture(8, 4, 1), kFrame_ns);
  camera.deliver(picture(8, 4, 2), 2 * kFrame_ns, V4L2_BUF_FLAG_ERROR);
  EXPECT_EQ(next(*capture), picture(8, 4, 1));
}

TEST_F(NaoCamera, SetsControlsAndNamesTheMissingOnes) {
  camera.known_controls = {V4L2_CID_GAIN};
  CameraSettings with = settings();
  with.controls = {{"gain", 16}, {"focus", 0}};
  ASSERT_TRUE(open(with));
  EXPECT_EQ(camera.controls, (std::vector<std::pair<std::uint32_t, std::int32_t>>{{V4L2_CID_GAIN, 16}}));
  EXPECT_EQ(warnings, std::vector<std::string>{"camera /dev/video-test: focus = 0 was not taken: Invalid argument"});
}

TEST_F(NaoCamera, NamesTheStepThatTheDeviceRefuses) {
  camera.format = V4L2_PIX_FMT_MJPEG;
  EXPECT_EQ(open(settings()).error(), "camera /dev/video-test: expected YUYV 8x4, got MJPG 8x4");
  camera.format = V4L2_PIX_FMT_YUYV;
  camera.busy = EBUSY;
  EXPECT_EQ(open(settings()).error(), "camera /dev/video-test belongs to another program");
  camera.busy = EINVAL;
  EXPECT_EQ(open(settings()).error(), "camera /dev/video-test: expected it to take a format, got Invalid argument");
  camera.plug(false);
  EXPECT_EQ(open(settings()).error(), "camera /dev/video-test: expected a video device, got No such file or directory");
}

TEST_F(NaoCamera, NoticesThatItIsGone) {
  auto capture = open(settings());
  ASSERT_TRUE(capture);
  camera.plug(false);
  EXPECT_EQ(capture->newest(1000).error(), "camera /dev/video-test is gone: No such device");
}

struct NaoCameraThread : NaoCamera {
  ~NaoCameraThread() override { set_report_listener({}); }

  void start() {
    set_report_listener([this](const Report& report) {
      const std::lock_guard guard(lock);
      said.push_back(report.sentence);
    });
    thread = std::make_unique<CameraThread>(
        "camera", settings(), std::make_unique<FakeVideo>(camera), memory.camera_top, clock,
        [this](std::uint64_t) { ++images; },
        /*try_again_ns=*/kMillisecond);
    ASSERT_TRUE(thread->start());
  }
  bool has_said(const std::string& sentence) {
    const std::lock_guard guard(lock);
    return std::find(said.begin(), said.end(), sentence) != said.end();
  }
  std::vector<std::string> all_said() {
    const std::lock_guard guard(lock);
    return said;
  }
  /// Delivers until an image of `seed` is in memory.
  void deliver_until_seen(int seed) {
    ASSERT_TRUE(tests::eventually([&] {
      camera.deliver(picture(8, 4, seed), monotonic_ns());
      const auto image = memory.camera_top.read();
      return image && image->value().data() == picture(8, 4, seed);
    }));
  }

  SessionClock clock;
  memory::Memory memory{"14/2", clock};
  std::mutex lock;
  std::vector<std::string> said;
  std::atomic<int> images = 0;
  std::unique_ptr<CameraThread> thread;
};

TEST_F(NaoCameraThread, WritesImagesWithTheDriversTime) {
  start();
  deliver_until_seen(1);
  const auto image = memory.camera_top.read();
  EXPECT_EQ(image->value().width(), 8u);
  EXPECT_EQ(image->value().height(), 4u);
  EXPECT_EQ(image->value().encoding(), foresight::Image::ENCODING_YUYV);
  EXPECT_LE(image->capture_ns(), clock.now_ns());
  EXPECT_GE(images, 1);
  // the driver's time, not the thread's
  const std::uint64_t long_ago_ns = monotonic_ns() - 5 * kSecond;
  ASSERT_TRUE(tests::eventually([&] {
    camera.deliver(picture(8, 4, 2), long_ago_ns);
    // the driver's times are whole microseconds
    const std::uint64_t early_ns = long_ago_ns + clock.epoch_offset_ns() - memory.camera_top.read()->capture_ns();
    return early_ns < 1000;
  }));
}

TEST_F(NaoCameraThread, ContinuesAfterTheCameraWasUnplugged) {
  start();
  deliver_until_seen(1);
  for (int round = 0; round < 3; ++round) {
    camera.plug(false);
    ASSERT_TRUE(tests::eventually([&] { return has_said("camera /dev/video-test is gone: No such device"); },
                                  tests::kLongestWait, [&] { return all_said(); }));
    camera.plug(true);
    deliver_until_seen(10 + round);
    ASSERT_TRUE(tests::eventually([&] { return has_said("camera /dev/video-test is back"); }, tests::kLongestWait,
                                  [&] { return all_said(); }));
    const std::lock_guard guard(lock);
    said.clear();
  }
  EXPECT_GE(camera.opened, 4);
}

TEST_F(NaoCameraThread, BeginsWhenThereIsACamera) {
  camera.plug(false);
  start();
  ASSERT_TRUE(tests::eventually(
      [&] { return has_said("camera /dev/video-test: expected a video device, got No such file or directory"); },
      tests::kLongestWait, [&] { return all_said(); }));
  camera.plug(true);
  deliver_until_seen(1);
}

TEST(NaoCameraOfARealFrame, ComesThroughAsItIs) {
  REAL_DATA_OR_SKIP(path, "frames/htwk_benchmark_640x480.yuv422");
  const std::string frame = *read_file(path, 1'000'000);
  FakeCamera camera;
  FakeVideo video(camera);
  std::vector<std::string> warnings;
  auto capture = VideoCapture::open(video, {.device = "/dev/video-test"}, warnings);
  ASSERT_TRUE(capture);
  camera.deliver(frame, kFrame_ns);
  const auto got = capture->newest(0);
  std::string image;
  capture->copy(**got, image);
  EXPECT_EQ(image, frame);
}

}  // namespace
}  // namespace robot::nao
