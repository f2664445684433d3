#include "robot/truth/sensor/video_driver.h"

#include <linux/videodev2.h>

#include <utility>

#include "robot/truth/sensor/image.h"
#include "robot/truth/sensor/kernel_camera.h"

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

std::optional<DepthFrame> depths_of(const nao::CameraSettings& settings, std::string_view pixels) {
  DepthFrame frame;
  frame.intrinsics = realsense_intrinsics(settings.width, settings.height);
  frame.depth = from_little_endian(pixels);
  return frame;
}

}  // namespace

std::unique_ptr<SensorDriver> video_driver(std::filesystem::path path, std::uint32_t width, std::uint32_t height,
                                           std::unique_ptr<nao::VideoDevice> device) {
  nao::CameraSettings settings{.device = std::move(path), .width = width, .height = height};
  return std::make_unique<KernelCamera>(std::move(settings), std::vector<std::uint32_t>{V4L2_PIX_FMT_Z16}, depths_of,
                                        std::move(device));
}

}  // namespace robot::truth
