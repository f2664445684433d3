#include "robot/truth/sensor/freenect_driver.h"

#include <libfreenect.h>
#include <sys/time.h>

#include <string>
#include <vector>

#include "robot/core/clock.h"
#include "robot/truth/sensor/device_clock.h"
#include "robot/truth/sensor/image.h"
#include "robot/truth/sensor/kinect.h"

namespace robot::truth {
namespace {

constexpr int kWidth = 640, kHeight = 480;  // [px]
constexpr double kTicksPerSecond = 60e6;
constexpr int kTickBits = 32;

class FreenectDriver final : public SensorDriver {
 public:
  explicit FreenectDriver(int number) : number_(number) {}
  ~FreenectDriver() override { stop(); }

  Result<void> open() override;
  void close() override { stop(); }
  Result<std::optional<DepthFrame>> newest(int patience_ms) override;

 private:
  Result<void> start();
  void stop();

  // libfreenect calls them within freenect_process_events_timeout()
  static void take_depth(freenect_device* device, void* depth, std::uint32_t ticks);
  static void take_colour(freenect_device* device, void* colour, std::uint32_t ticks);

  int number_;
  freenect_context* context_ = nullptr;
  freenect_device* device_ = nullptr;
  DeviceClock clock_{kTicksPerSecond, kTickBits};
  SessionClock epoch_;

  GreyImage disparities_;
  std::optional<std::uint64_t> capture_ns_;  // of `disparities_`, until newest() returns them
  ColourImage colour_;                       // empty before the first one
};

/// Closes the sensor again if a step of its start is refused.
Result<void> FreenectDriver::open() {
  Result<void> started = start();
  if (!started) stop();
  return started;
}

Result<void> FreenectDriver::start() {
  if (freenect_init(&context_, nullptr) < 0) return Error{"expected USB, libfreenect found none"};
  freenect_set_log_level(context_, FREENECT_LOG_FATAL);
  freenect_select_subdevices(context_, FREENECT_DEVICE_CAMERA);
  const int devices = freenect_num_devices(context_);
  if (number_ >= devices)
    return Error{"expected a Kinect with the number " + std::to_string(number_) + ", found " + std::to_string(devices) +
                 " (from 0 on)"};
  if (freenect_open_device(context_, &device_, number_) < 0)
    return Error{"the Kinect does not open; another program may use it, or you may lack the right to use it"};

  freenect_set_user(device_, this);
  freenect_set_depth_callback(device_, take_depth);
  freenect_set_video_callback(device_, take_colour);
  const auto depth = freenect_find_depth_mode(FREENECT_RESOLUTION_MEDIUM, FREENECT_DEPTH_11BIT);
  const auto colour = freenect_find_video_mode(FREENECT_RESOLUTION_MEDIUM, FREENECT_VIDEO_RGB);
  if (freenect_set_depth_mode(device_, depth) < 0 || freenect_set_video_mode(device_, colour) < 0)
    return Error{"the Kinect refuses images of 640x480 px"};
  if (freenect_start_depth(device_) < 0 || freenect_start_video(device_) < 0)
    return Error{"the Kinect does not start; is its power supply connected?"};
  return {};
}

void FreenectDriver::stop() {
  if (device_) {
    freenect_stop_depth(device_);
    freenect_stop_video(device_);
    freenect_close_device(device_);
  }
  if (context_) freenect_shutdown(context_);
  device_ = nullptr;
  context_ = nullptr;
  clock_ = DeviceClock(kTicksPerSecond, kTickBits);
  capture_ns_.reset();
  colour_ = {};
}

Result<std::optional<DepthFrame>> FreenectDriver::newest(int patience_ms) {
  const std::uint64_t end_ns = monotonic_ns() + static_cast<std::uint64_t>(patience_ms) * kMillisecond;
  while (!capture_ns_) {
    const std::uint64_t now_ns = monotonic_ns();
    if (now_ns >= end_ns) return std::optional<DepthFrame>();
    timeval patience{.tv_sec = static_cast<time_t>((end_ns - now_ns) / kSecond),
                     .tv_usec = static_cast<suseconds_t>((end_ns - now_ns) % kSecond / 1000)};
    if (freenect_process_events_timeout(context_, &patience) < 0) return Error{"the Kinect is gone"};
  }
  Result<DepthFrame> frame = kinect_frame(disparities_, colour_.rgb.empty() ? nullptr : &colour_);
  if (frame) frame->capture_ns = *capture_ns_;
  capture_ns_.reset();
  if (!frame) return frame.failure();
  return std::optional(*std::move(frame));
}

void FreenectDriver::take_depth(freenect_device* device, void* depth, std::uint32_t ticks) {
  auto& driver = *static_cast<FreenectDriver*>(freenect_get_user(device));
  const auto* values = static_cast<const std::uint16_t*>(depth);
  driver.disparities_ = {kWidth, kHeight, {values, values + kWidth * kHeight}};
  driver.capture_ns_ = driver.clock_.capture_ns(ticks, driver.epoch_.now_ns());
}

void FreenectDriver::take_colour(freenect_device* device, void* colour, std::uint32_t) {
  auto& driver = *static_cast<FreenectDriver*>(freenect_get_user(device));
  const auto* values = static_cast<const std::uint8_t*>(colour);
  driver.colour_ = {kWidth, kHeight, {values, values + 3 * kWidth * kHeight}};
}

}  // namespace

std::unique_ptr<SensorDriver> freenect_driver(int number) { return std::make_unique<FreenectDriver>(number); }

}  // namespace robot::truth
