#include "robot/truth/sensor/kernel_camera.h"

#include <linux/videodev2.h>

#include <string>
#include <utility>

namespace robot::truth {

KernelCamera::KernelCamera(nao::CameraSettings settings, std::vector<std::uint32_t> formats, FrameOf frame_of,
                           std::unique_ptr<nao::VideoDevice> device)
    : settings_(std::move(settings)), formats_(std::move(formats)), frame_of_(frame_of), device_(std::move(device)) {}

Result<void> KernelCamera::open() {
  std::vector<std::string> no_controls;
  std::string problem;
  for (const std::uint32_t format : formats_) {
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

Result<std::optional<DepthFrame>> KernelCamera::newest(int patience_ms) {
  const auto captured = capture_->newest(patience_ms);
  if (!captured) return captured.failure();
  if (!*captured) return std::optional<DepthFrame>();
  std::string rows;
  std::string_view pixels((*captured)->pixels, (*captured)->bytes);
  if (settings_.format != V4L2_PIX_FMT_MJPEG) {
    capture_->copy(**captured, rows);
    pixels = rows;
  }
  std::optional<DepthFrame> frame = frame_of_(settings_, pixels);
  capture_->give_back(**captured);
  if (frame) frame->capture_ns = (*captured)->capture_ns + epoch_.epoch_offset_ns();
  return frame;
}

}  // namespace robot::truth
