// Images of PCL's recordings (pcl_openni_grabber_…, *.pclzf).
#pragma once

#include <string_view>

#include "robot/core/result.h"
#include "robot/truth/sensor/image.h"

namespace robot::truth {

/// Reads a depth image (type depth16).
Result<GreyImage> read_pclzf_depth(std::string_view bytes);

/// Reads a colour image (type rgb24), whose file holds all red values, then all green ones, then all blue ones.
Result<ColourImage> read_pclzf_colour(std::string_view bytes);

}  // namespace robot::truth
