// An orange ball in a camera's picture. Pure.
#pragma once

#include <optional>
#include <string_view>

namespace robot::lab {

/// A picture in YUYV: 2 bytes per pixel, no gaps between rows.
struct Picture {
  int width = 0, height = 0;  // [px]
  std::string_view yuyv;      // 2 * width * height bytes
};

/// A whole ball in a picture.
struct FoundBall {
  double x = 0, y = 0;                              // [px] centre
  double radius = 0;                                // [px] of the circle with the same area
  double left = 0, top = 0, width = 0, height = 0;  // [px] bounding box
};

/// Returns the largest round orange patch, or nothing without one. A patch that the border cuts has no size and does not
/// count. Rows below `last_row` [px] do not count either: they may show the robot's own red chest.
std::optional<FoundBall> find_orange_ball(const Picture& picture, int last_row);

}  // namespace robot::lab
