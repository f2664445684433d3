// Ordinary cameras: their images have colours and no depths.
#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>

#include "robot/nao/camera/video_device.h"
#include "robot/truth/frame/depth_frame.h"
#include "robot/truth/sensor/image.h"
#include "robot/truth/sensor/sensor_driver.h"

namespace robot::truth {

/// Returns the image of an ordinary camera. Its pinhole is that of a usual webcam; a calibration fits the focal length.
DepthFrame picture_frame(ColourImage image, std::uint64_t capture_ns);

/// Returns the driver of the video device at `path` for images of this size [px]. It streams MJPEG, or YUYV if it has no
/// MJPEG: USB 2 carries uncompressed 1280x720 at 10 images a second only.
/// Capture times are those of kernel_camera.h.
std::unique_ptr<SensorDriver> picture_driver(std::filesystem::path path, std::uint32_t width, std::uint32_t height,
                                             std::unique_ptr<nao::VideoDevice> device);

}  // namespace robot::truth
