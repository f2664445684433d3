#include "robot/truth/sensor/ordinary_camera.h"

#include <linux/videodev2.h>

#include <optional>
#include <string_view>
#include <utility>
#include <vector>

#include "robot/truth/sensor/colour_codec.h"
#include "robot/truth/sensor/kernel_camera.h"

namespace robot::truth {
namespace {

constexpr double kUsualFocal = 0.9;  // times the width: 58 degrees, a webcam

std::optional<DepthFrame> colours_of(const nao::CameraSettings& settings, std::string_view pixels) {
  Result<ColourImage> colours =
      settings.format == V4L2_PIX_FMT_MJPEG
          ? read_jpeg(pixels, Damage::accepted)
          : colour_of_yuyv(pixels, static_cast<int>(settings.width), static_cast<int>(settings.height));
  if (!colours) return std::nullopt;
  return picture_frame(*std::move(colours), 0);
}

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
  return std::make_unique<KernelCamera>(std::move(settings),
                                        std::vector<std::uint32_t>{V4L2_PIX_FMT_MJPEG, V4L2_PIX_FMT_YUYV}, colours_of,
                                        std::move(device));
}

}  // namespace robot::truth
