// A live sensor that may be unplugged and plugged in again at any time.
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <string>

#include "robot/core/clock.h"
#include "robot/truth/frame/depth_source.h"
#include "robot/truth/sensor/camera_file.h"
#include "robot/truth/sensor/sensor_driver.h"

namespace robot::truth {

/// The passing of time, which a test replaces.
struct Waiting {
  std::function<std::uint64_t()> now_ns = monotonic_ns;
  std::function<void(std::uint64_t)> rest_until = rest_until_ns;  // [ns, of now_ns]

  /// Sleeps until the monotonic clock shows `time_ns`.
  static void rest_until_ns(std::uint64_t time_ns);
};

/// A source that opens its sensor at the first call of next(), and again a second after each failure.
class LiveSource final : public DepthSource {
 public:
  /// Seconds without an image after which an open sensor is opened anew. A Kinect takes two seconds to start.
  static constexpr int kPatience = 4;

  /// `camera` is a person's knowledge of the sensor, which replaces the driver's.
  LiveSource(std::string address, std::unique_ptr<SensorDriver> driver, CameraFile camera, Waiting waiting = {})
      : address_(std::move(address)),
        driver_(std::move(driver)),
        camera_(std::move(camera)),
        waiting_(std::move(waiting)) {}
  ~LiveSource() override { driver_->close(); }

  Result<std::optional<DepthFrame>> next() override;
  const std::string& address() const override { return address_; }
  bool live() const override { return true; }

 private:
  Result<std::optional<DepthFrame>> within_a_second();
  Error lost(const Error& reason);
  Error silent();

  std::string address_;
  std::unique_ptr<SensorDriver> driver_;
  CameraFile camera_;
  Waiting waiting_;
  bool open_ = false;
  int silent_s_ = 0;                // calls since the last image, of a second each
  std::uint64_t try_again_ns_ = 0;  // [ns, of now_ns] the sensor is not opened before
};

}  // namespace robot::truth
