// A printed tag in a picture.
#pragma once

#include <Eigen/Core>
#include <array>

namespace robot::truth::tags {

/// The corners of the black square [px]: lower left, lower right, upper right, upper left in the upright print.
using Corners = std::array<Eigen::Vector2d, 4>;

struct SeenTag {
  int id = 0;
  double margin = 0;  // [0..255] mean contrast of a bit of the code against the threshold
  Corners corners;
};

}  // namespace robot::truth::tags
