// The pixels of a kind around a place in an image.
#pragma once

#include <Eigen/Core>
#include <algorithm>

#include "robot/truth/frame/depth_frame.h"

namespace robot::truth {

struct PixelPatch {
  Eigen::Vector2d sum = Eigen::Vector2d::Zero();  // of their centres [px]
  int count = 0;

  /// Returns the middle of one or more pixels [px].
  Eigen::Vector2d middle() const { return sum / count; }
};

/// Returns the pixels within `radius` [px] of a place for which is_one(row, column) holds.
template <class Test>
PixelPatch patch_around(const Intrinsics& image, const Eigen::Vector2d& place, double radius, Test&& is_one) {
  PixelPatch patch;
  const int first_row = std::max(0, static_cast<int>(place.y() - radius));
  const int end_row = std::min(image.height, static_cast<int>(place.y() + radius) + 1);
  const int first_column = std::max(0, static_cast<int>(place.x() - radius));
  const int end_column = std::min(image.width, static_cast<int>(place.x() + radius) + 1);
  for (int row = first_row; row < end_row; ++row)
    for (int column = first_column; column < end_column; ++column) {
      const Eigen::Vector2d centre(column + 0.5, row + 0.5);
      if ((centre - place).squaredNorm() > radius * radius || !is_one(row, column)) continue;
      patch.sum += centre;
      ++patch.count;
    }
  return patch;
}

/// Returns the patch that a circle around `place` has in its middle after some steps towards it. Its count is 0 when the
/// circle is empty.
template <class Test>
PixelPatch centred_patch(const Intrinsics& image, Eigen::Vector2d place, double radius, Test&& is_one) {
  PixelPatch patch;
  for (int step = 0; step < 3; ++step) {
    patch = patch_around(image, place, radius, is_one);
    if (patch.count == 0) break;
    place = patch.middle();
  }
  return patch;
}

}  // namespace robot::truth
