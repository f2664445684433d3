// Robots that lie on the ground, by the shapes of their boxes.
#pragma once

#include <vector>

#include "robot/lab/import/label_rows.h"

namespace robot::lab::labels {

/// The height of a standing robot's box as a function of its place in the image.
class Stance {
 public:
  /// Fits the height to the boxes. Boxes of robots that lie are left out as outliers. Without enough boxes no robot lies.
  explicit Stance(const std::vector<Frame>& frames);

  /// Returns true if the box is lower than 0.68 of that height and wider than 0.62 of its own height.
  bool lies(const Box& box) const;

 private:
  double standing_height(const Box& box) const;  // [px]

  std::vector<double> factors_;  // of 1, u, u², v, v², u² v; empty: not fitted
};

}  // namespace robot::lab::labels
