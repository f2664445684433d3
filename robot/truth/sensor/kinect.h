// The first Kinect's nominal geometry, and the depth images that its raw values make.
#pragma once

#include <cstdint>

#include "robot/core/result.h"
#include "robot/truth/frame/depth_frame.h"
#include "robot/truth/sensor/image.h"

namespace robot::truth {

/// The value of a pixel in which the Kinect measured no disparity, and the greatest one there is.
inline constexpr std::uint16_t kNoDisparity = 2047;

/// Returns the pinhole of the Kinect's depth camera for an image of this size, which shows its whole view.
Intrinsics kinect_intrinsics(int width, int height);

/// Returns the depth [mm] of an 11-bit disparity, or 0 for a disparity of no depth below 65 m.
std::uint16_t depth_of_disparity(std::uint16_t disparity);

/// Makes a depth image of disparities and, if `colour` is not nullptr, of the colour camera's image of the same moment.
/// Returns an Error if a value is no disparity: the image is damaged, or its bytes are in another order.
Result<DepthFrame> kinect_frame(const GreyImage& disparities, const ColourImage* colour);

/// Returns the colours of a depth image's pixels, by the nominal place of the Kinect's colour camera. A pixel without a
/// depth takes the depth to its left; it is black if there is none, or if the colour camera does not see it.
/// The two cameras of a real Kinect differ from the nominal ones by some pixels; no sensor was at hand to measure it.
std::vector<std::uint8_t> registered_colours(const DepthFrame& frame, const ColourImage& colour);

}  // namespace robot::truth
