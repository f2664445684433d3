// A field and small cameras for tests: a small image is drawn in a tenth of the time.
#pragma once

#include "robot/truth/synthetic/sensor_poses.h"
#include "robot/truth/synthetic/surroundings.h"
#include "tests/sim/support/fields.h"

namespace robot::truth {

using sim::kField2012;
inline constexpr Surroundings kHall{.field = kField2012};

/// A camera with the view of a Kinect and a quarter of its pixels in each direction.
inline constexpr Intrinsics kSmall{
    .width = 160, .height = 120, .focal_x = 143.95, .focal_y = 143.95, .centre_x = 80, .centre_y = 60};

/// The same with half of the pixels in each direction.
inline constexpr Intrinsics kHalf{
    .width = 320, .height = 240, .focal_x = 287.9, .focal_y = 287.9, .centre_x = 160, .centre_y = 120};

/// Returns the place of a pixel in the vectors of an image.
inline std::size_t pixel_index(const Intrinsics& image, int row, int column) {
  return static_cast<std::size_t>(row) * static_cast<std::size_t>(image.width) + static_cast<std::size_t>(column);
}

}  // namespace robot::truth
