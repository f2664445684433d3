// Depth cameras that the kernel itself drives as video devices (V4L2, format Z16): Intel RealSense.
#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>

#include "robot/nao/camera/video_device.h"
#include "robot/truth/sensor/sensor_driver.h"

namespace robot::truth {

/// Returns the driver of the video device at `path` for images of this size. Its intrinsics are those of an Intel RealSense
/// D435, because V4L2 knows none: a camera file should replace them.
/// Capture times are those of kernel_camera.h.
std::unique_ptr<SensorDriver> video_driver(std::filesystem::path path, std::uint32_t width, std::uint32_t height,
                                           std::unique_ptr<nao::VideoDevice> device);

}  // namespace robot::truth
