// A sensor that is absent, silent, unplugged and plugged in again. No test waits: the time is the test's.
#include "robot/truth/sensor/live_source.h"

#include <gtest/gtest.h>

#include <utility>

namespace robot::truth {
namespace {

/// The sensor at the other end of the cable, and the time.
struct Bench {
  bool plugged = true, sends = true, open = false;
  int opened = 0;
  std::uint64_t now_ns = 100 * kSecond;
  std::uint64_t images = 0;

  Waiting waiting() {
    return {.now_ns = [this] { return now_ns; },
            .rest_until = [this](std::uint64_t time_ns) { now_ns = std::max(now_ns, time_ns); }};
  }
};

class BenchDriver final : public SensorDriver {
 public:
  explicit BenchDriver(Bench& bench) : bench_(bench) {}

  Result<void> open() override {
    EXPECT_FALSE(bench_.open);
    if (!bench_.plugged) return Error{"no sensor"};
    bench_.open = true;
    ++bench_.opened;
    return {};
  }

  void close() override { bench_.open = false; }

  Result<std::optional<DepthFrame>> newest(int patience_ms) override {
    EXPECT_TRUE(bench_.open);
    if (!bench_.plugged) return Error{"the sensor is gone"};
    if (!bench_.sends) {
      // a damaged image ends the wait early
      EXPECT_LE(patience_ms, 1000);
      bench_.now_ns += std::min<std::uint64_t>(300, static_cast<std::uint64_t>(patience_ms)) * kMillisecond;
      return std::optional<DepthFrame>();
    }
    bench_.now_ns += kSecond / 30;
    DepthFrame frame;
    frame.capture_ns = ++bench_.images;
    return std::optional(std::move(frame));
  }

 private:
  Bench& bench_;
};

struct LiveSourceTest : ::testing::Test {
  std::unique_ptr<LiveSource> open(const CameraFile& camera = {}) {
    return std::make_unique<LiveSource>("bench:0", std::make_unique<BenchDriver>(bench), camera, bench.waiting());
  }

  /// Returns the number of the next image, or the error.
  static std::string next(LiveSource& source) {
    const auto frame = source.next();
    if (!frame) return frame.error();
    return *frame ? std::to_string((*frame)->capture_ns) : "the end";
  }

  Bench bench;
};

TEST_F(LiveSourceTest, OpensItsSensorAtTheFirstImage) {
  const auto source = open();
  EXPECT_EQ(bench.opened, 0);
  EXPECT_EQ(source->address(), "bench:0");
  EXPECT_TRUE(source->live());
  for (const char* image : {"1", "2", "3"}) EXPECT_EQ(next(*source), image);
  EXPECT_EQ(bench.opened, 1);
}

TEST_F(LiveSourceTest, ReportsAnAbsentSensorOnceASecond) {
  bench.plugged = false;
  const auto source = open();
  const std::uint64_t start_ns = bench.now_ns;
  for (std::uint64_t second = 0; second < 5; ++second) {
    EXPECT_EQ(next(*source), "bench:0: no sensor");
    EXPECT_EQ(bench.now_ns, start_ns + second * kSecond);
  }
  bench.plugged = true;
  EXPECT_EQ(next(*source), "1");
}

TEST_F(LiveSourceTest, OpensItsSensorAgainWhenItIsPluggedInAgain) {
  const auto source = open();
  for (int round = 0; round < 3; ++round) {
    EXPECT_EQ(next(*source), std::to_string(round + 1));
    bench.plugged = false;
    const std::uint64_t gone_ns = bench.now_ns;
    EXPECT_EQ(next(*source), "bench:0: the sensor is gone");
    EXPECT_FALSE(bench.open);
    EXPECT_EQ(next(*source), "bench:0: no sensor");
    EXPECT_EQ(bench.now_ns, gone_ns + kSecond);
    bench.plugged = true;
  }
  EXPECT_EQ(next(*source), "4");
  EXPECT_EQ(bench.opened, 4);
}

TEST_F(LiveSourceTest, OpensASilentSensorAnew) {
  const auto source = open();
  EXPECT_EQ(next(*source), "1");
  bench.sends = false;
  for (int second = 1; second <= LiveSource::kPatience; ++second) {
    EXPECT_TRUE(bench.open);
    const std::uint64_t start_ns = bench.now_ns;
    EXPECT_EQ(next(*source), "bench:0: the sensor sends no images");
    EXPECT_EQ(bench.now_ns, start_ns + kSecond);
  }
  EXPECT_FALSE(bench.open);
  bench.sends = true;
  EXPECT_EQ(next(*source), "2");
  EXPECT_EQ(bench.opened, 2);
}

TEST_F(LiveSourceTest, ASlowStartIsNoLoss) {
  bench.sends = false;
  const auto source = open();
  EXPECT_EQ(next(*source), "bench:0: the sensor sends no images");
  EXPECT_EQ(next(*source), "bench:0: the sensor sends no images");
  bench.sends = true;
  EXPECT_EQ(next(*source), "1");
  EXPECT_EQ(bench.opened, 1);
}

TEST_F(LiveSourceTest, TheCameraFileReplacesTheDriversIntrinsics) {
  const auto source = open({.focal_x = 600, .unit = 0.0001});
  const auto frame = source->next();
  ASSERT_TRUE(frame && *frame);
  EXPECT_EQ((*frame)->intrinsics.focal_x, 600);
  EXPECT_EQ((*frame)->intrinsics.focal_y, Intrinsics{}.focal_y);
  EXPECT_EQ((*frame)->unit, 0.0001);
}

TEST_F(LiveSourceTest, ReportsTheCameraFileOfAnotherSensorOnceASecond) {
  const auto source = open({.width = 848});
  const std::uint64_t start_ns = bench.now_ns;
  for (int i = 0; i < 3; ++i)
    EXPECT_EQ(next(*source), "bench:0: expected 848x480 px, for which the camera file is made, got 640x480");
  EXPECT_GE(bench.now_ns, start_ns + 2 * kSecond);
}

TEST_F(LiveSourceTest, ClosesItsSensorAtTheEnd) {
  auto source = open();
  EXPECT_EQ(next(*source), "1");
  EXPECT_TRUE(bench.open);
  source.reset();
  EXPECT_FALSE(bench.open);
}

}  // namespace
}  // namespace robot::truth
