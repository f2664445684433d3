#include "robot/truth/sensor/ordinary_camera.h"

#include <linux/videodev2.h>

#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "robot/core/clock.h"
#include "robot/nao/camera/video_capture.h"
#include "robot/truth/sensor/colour_codec.h"

namespace robot::truth {
namespace {

constexpr double kUsualFocal = 0.9;  // times the width: 58 degrees, a webcam

class PictureDriver final : public SensorDriver {
 public:
  PictureDriver(nao::CameraSettings settings, std::unique_ptr<nao::VideoDevice> device)
      : settings_(std::move(settings)), device_(std::move(device)) {}

  Result<void> open() override {
    std::vector<std::string> no_controls;
    std::string problem;
    for (const std::uint32_t format : {V4L2_PIX_FMT_MJPEG, V4L2_PIX_FMT_YUYV}) {
      settings_.format = format;
      Result<nao::VideoCapture> capture = nao::VideoCapture::open(*device_, settings_, no_controls);
      if (capture) {
        capture_.emplace(*std::move(capture));
        return {};
      }
      problem = capture.error();
    }
    return Error{problem};
  }

  void close() override { capture_.reset(); }

  Result<std::optional<DepthFrame>> newest(int patience_ms) override {
    const auto captured = capture_->newest(patience_ms);
    if (!captured) return captured.failure();
    if (!*captured) return std::optional<DepthFrame>();
    Result<ColourImage> colours = colours_of(**captured);
    capture_->give_back(**captured);
    if (!colours) return std::optional<DepthFrame>();
    return std::optional(picture_frame(*std::move(colours), (*captured)->capture_ns + epoch_.epoch_offset_ns()));
  }

 private:
  Result<ColourImage> colours_of(const nao::VideoCapture::Frame& frame) const {
    if (settings_.format == V4L2_PIX_FMT_MJPEG) return read_jpeg({frame.pixels, frame.bytes}, Damage::accepted);
    std::string yuyv;
    capture_->copy(frame, yuyv);
    return colour_of_yuyv(yuyv, static_cast<int>(settings_.width), static_cast<int>(settings_.height));
  }

  nao::CameraSettings settings_;
  std::unique_ptr<nao::VideoDevice> device_;  // outlives `capture_`
  std::optional<nao::VideoCapture> capture_;
  SessionClock epoch_;
};

}  // namespace

DepthFrame picture_frame(ColourImage image, std::uint64_t capture_ns) {
  const double focal = kUsualFocal * image.width;
  DepthFrame frame{.intrinsics = {.width = image.width,
                                  .height = image.height,
                                  .focal_x = focal,
                                  .focal_y = focal,
                                  .centre_x = 0.5 * image.width,
                                  .centre_y = 0.5 * image.height,
                                  .baseline = 0}};
  frame.rgb = std::move(image.rgb);
  frame.capture_ns = capture_ns;
  return frame;
}

std::unique_ptr<SensorDriver> picture_driver(std::filesystem::path path, std::uint32_t width, std::uint32_t height,
                                             std::unique_ptr<nao::VideoDevice> device) {
  nao::CameraSettings settings{.device = std::move(path), .width = width, .height = height};
  return std::make_unique<PictureDriver>(std::move(settings), std::move(device));
}

}  // namespace robot::truth
