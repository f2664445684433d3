// Frames of one Video4Linux device. The newest frame replaces older ones.
#pragma once

#include <linux/videodev2.h>

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "robot/core/result.h"
#include "robot/nao/camera/video_device.h"

namespace robot::nao {

struct CameraSettings {
  std::filesystem::path device;
  std::uint32_t width = 640, height = 480;  // [px]
  std::uint32_t rate = 30;                  // [1/s]
  /// The device's pixel format: one with 2 bytes a pixel, such as V4L2_PIX_FMT_Z16, or a compressed one, V4L2_PIX_FMT_MJPEG.
  std::uint32_t format = V4L2_PIX_FMT_YUYV;
  bool turned = false;  // the camera is mounted upside down; YUYV only

  /// Values of the driver's controls, by the names in kControls. A control that the device lacks causes one warning.
  std::map<std::string, std::int32_t> controls;
};

/// Returns the kernel's number of a control ("exposure", "gain", "auto_white_balance", …), or nothing for an unknown
/// name.
std::optional<std::uint32_t> control_id(const std::string& name);

/// A device that streams into buffers shared with the kernel. Used by one thread; the device outlives it.
class VideoCapture {
 public:
  static constexpr std::uint32_t kBuffers = 3;

  /// Sets the device up and starts it. Returns an Error that names the refused step, or the program that has the
  /// device. Adds a warning for each control that the device lacks.
  static Result<VideoCapture> open(VideoDevice& device, const CameraSettings& settings,
                                   std::vector<std::string>& warnings);
  VideoCapture(VideoCapture&& other) noexcept;
  VideoCapture& operator=(VideoCapture&&) = delete;
  ~VideoCapture();

  struct Frame {
    const char* pixels = nullptr;  // rows of `stride` bytes, in the sensor's order
    std::uint32_t stride = 0;      // 0: compressed
    std::size_t bytes = 0;         // of the whole frame
    std::uint64_t capture_ns = 0;  // [ns, monotonic clock] time stamp of the kernel
    std::uint32_t buffer = 0;
  };

  /// Returns the newest frame, or nothing if none came within `patience_ms`. Older frames go back to the device unread.
  /// Returns an Error if the device is gone. Give each frame back before the next call.
  Result<std::optional<Frame>> newest(int patience_ms);
  void give_back(const Frame& frame);

  /// Appends the YUYV frame to `image`, upright and without padding. This is the only copy.
  void copy(const Frame& frame, std::string& image) const;

  std::uint64_t passed_over() const { return passed_over_; }  // frames replaced by a newer one

 private:
  struct Buffer {
    void* memory = nullptr;
    std::size_t bytes = 0;
  };

  VideoCapture(VideoDevice& device, CameraSettings settings) : device_(&device), settings_(std::move(settings)) {}

  Result<void> set_format();
  void set_controls(std::vector<std::string>& warnings);
  Result<void> share_buffers();
  Error refused(const std::string& what, int error_number) const;

  VideoDevice* device_;
  CameraSettings settings_;
  std::uint32_t stride_ = 0;
  std::vector<Buffer> buffers_;
  std::uint64_t passed_over_ = 0;
};

}  // namespace robot::nao
