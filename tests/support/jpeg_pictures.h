// Pictures as JPEG.
#pragma once

#include <string>

#include "robot/truth/frame/depth_frame.h"
#include "robot/truth/sensor/image.h"

namespace tests {

/// Returns the JPEG of a picture, 4:2:2.
std::string jpeg_of(const robot::truth::ColourImage& picture, int quality);

/// Returns the picture after compression as a JPEG.
robot::truth::DepthFrame as_jpeg(const robot::truth::DepthFrame& picture, int quality);

}  // namespace tests
