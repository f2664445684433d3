// The intrinsics that PCL stores beside each image of a recording (frame_TIME.xml).
#pragma once

#include <string_view>

#include "robot/core/result.h"
#include "robot/truth/frame/depth_frame.h"

namespace robot::truth {

struct PclCamera {
  double focal_x = 0, focal_y = 0, centre_x = 0, centre_y = 0;  // [px] of the depth image
  double unit = 0.001;                                          // [m] of one step of the depth
};

/// Reads the part <depth> of the file. Its other parts do not matter. A file without a unit means millimetres.
Result<PclCamera> parse_pcl_camera(std::string_view xml);

}  // namespace robot::truth
