#include "robot/truth/sensor/video_driver.h"

#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "robot/core/clock.h"
#include "robot/nao/camera/video_capture.h"
#include "robot/truth/sensor/image.h"

namespace robot::truth {
namespace {

/// Returns the nominal pinhole of a D435: 384.2 px at 640x480 (realsense-ros issue 2788), lenses 50 mm apart (data sheet).
/// Its images of other widths show the same view.
Intrinsics realsense_intrinsics(std::uint32_t width, std::uint32_t height) {
  const double focal = 384.2 * width / 640;
  return {.width = static_cast<int>(width),
          .height = static_cast<int>(height),
          .focal_x = focal,
          .focal_y = focal,
          .centre_x = width / 2.0,
          .centre_y = height / 2.0,
          .baseline = 0.05};
}

class VideoDriver final : public SensorDriver {
 public:
  VideoDriver(nao::CameraSettings settings, std::unique_ptr<nao::VideoDevice> device)
      : settings_(std::move(settings)), device_(std::move(device)) {}

  Result<void> open() override {
    std::vector<std::string> no_controls;
    Result<nao::VideoCapture> capture = nao::VideoCapture::open(*device_, settings_, no_controls);
    if (!capture) return capture.failure();
    capture_.emplace(*std::move(capture));
    return {};
  }

  void close() override { capture_.reset(); }

  Result<std::optional<DepthFrame>> newest(int patience_ms) override {
    const auto captured = capture_->newest(patience_ms);
    if (!captured) return captured.failure();
    if (!*captured) return std::optional<DepthFrame>();
    std::string values;
    capture_->copy(**captured, values);
    capture_->give_back(**captured);

    DepthFrame frame;
    frame.intrinsics = realsense_intrinsics(settings_.width, settings_.height);
    frame.depth = from_little_endian(values);
    frame.capture_ns = (*captured)->capture_ns + epoch_.epoch_offset_ns();
    return std::optional(std::move(frame));
  }

 private:
  nao::CameraSettings settings_;
  std::unique_ptr<nao::VideoDevice> device_;  // outlives `capture_`
  std::optional<nao::VideoCapture> capture_;
  SessionClock epoch_;
};

}  // namespace

std::unique_ptr<SensorDriver> video_driver(std::filesystem::path path, std::uint32_t width, std::uint32_t height,
                                           std::unique_ptr<nao::VideoDevice> device) {
  nao::CameraSettings settings{.device = std::move(path), .width = width, .height = height, .format = V4L2_PIX_FMT_Z16};
  return std::make_unique<VideoDriver>(std::move(settings), std::move(device));
}

}  // namespace robot::truth
