// Cameras that the kernel drives as video devices (V4L2), of any format.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string_view>
#include <vector>

#include "robot/core/clock.h"
#include "robot/nao/camera/video_capture.h"
#include "robot/nao/camera/video_device.h"
#include "robot/truth/sensor/sensor_driver.h"

namespace robot::truth {

/// The driver of one video device. The capture time of an image is the kernel's time stamp (of the monotonic clock) plus the
/// offset to the epoch when the driver was made.
class KernelCamera final : public SensorDriver {
 public:
  /// Makes an image of pixels without padding, or of a JPEG, in the format of `settings`. Returns nothing for a damaged one.
  using FrameOf = std::optional<DepthFrame> (*)(const nao::CameraSettings& settings, std::string_view pixels);

  /// Streams the first of `formats` that the device has.
  KernelCamera(nao::CameraSettings settings, std::vector<std::uint32_t> formats, FrameOf frame_of,
               std::unique_ptr<nao::VideoDevice> device);

  Result<void> open() override;
  void close() override { capture_.reset(); }
  Result<std::optional<DepthFrame>> newest(int patience_ms) override;

 private:
  nao::CameraSettings settings_;
  std::vector<std::uint32_t> formats_;
  FrameOf frame_of_;
  std::unique_ptr<nao::VideoDevice> device_;  // outlives `capture_`
  std::optional<nao::VideoCapture> capture_;
  SessionClock epoch_;
};

}  // namespace robot::truth
