// Frames of one Video4Linux device: the newest wins.
#pragma once

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
  bool turned = false;                      // it is mounted upside down

  /// What the driver is told, by the names of kControls; one that the device lacks is told once and left out.
  std::map<std::string, std::int32_t> controls;
};

/// The number by which the kernel knows a control ("exposure", "gain", "auto_white_balance", …); nothing for another name.
std::optional<std::uint32_t> control_id(const std::string& name);

/// A device that streams YUYV into buffers which the kernel and we share. Used by one thread; the device outlives it.
class VideoCapture {
 public:
  static constexpr std::uint32_t kBuffers = 3;

  /// Sets the device up and starts it. An Error says what it refused, and whose it is where somebody else has it.
  /// `warnings`: controls that it lacks.
  static Result<VideoCapture> open(VideoDevice& device, const CameraSettings& settings,
                                   std::vector<std::string>& warnings);
  VideoCapture(VideoCapture&& other) noexcept;
  VideoCapture& operator=(VideoCapture&&) = delete;
  ~VideoCapture();

  struct Frame {
    const char* pixels = nullptr;  // rows of `stride` bytes, in the order of the sensor
    std::uint32_t stride = 0;
    std::uint64_t capture_ns = 0;  // [ns, monotonic clock] as the kernel stamped it
    std::uint32_t buffer = 0;
  };

  /// The newest frame, once there is one; older ones go back to the device unseen. Nothing if none came within
  /// `patience_ms`. An Error: the device is gone. Each frame is given back before the next one is asked for.
  Result<std::optional<Frame>> newest(int patience_ms);
  void give_back(const Frame& frame);

  /// Appends the frame to `image`, upright and without padding: the only copy there is.
  void copy(const Frame& frame, std::string& image) const;

  std::uint64_t passed_over() const { return passed_over_; }  // frames that a newer one replaced

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
