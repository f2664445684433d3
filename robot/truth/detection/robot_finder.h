// The robots in a grid of the surface above the carpet.
#pragma once

#include <vector>

#include "robot/truth/detection/detector_options.h"
#include "robot/truth/detection/ground_grid.h"
#include "robot/truth/detection/sight.h"
#include "robot/truth/frame/detections.h"

namespace robot::truth {

/// The lower ends [m] of the layers of a grid, by the height of a robot: hips, chin, and more than a robot's head.
struct LayerHeights {
  explicit LayerHeights(double robot_height)
      : body(static_cast<float>(0.35 * robot_height)),
        head(static_cast<float>(robot_height - 0.13)),
        tall(static_cast<float>(robot_height + 0.14)) {}

  Layer layer_at(float height) const {
    return height < body ? Layer::low : height < head ? Layer::body : height < tall ? Layer::head : Layer::tall;
  }

  float body, head, tall;
};

/// Adds the robots in the grid to `robots` and removes their surface from it.
///
/// A standing robot is found by its head. A head is a small disc that arms and heading do not move, and heads are apart even
/// when robots touch. A robot without a visible head is found by its body, and a lying one by the low layer. A thing with
/// something tall above it is a person. A robot at the border of the image is left out, because its middle is not visible.
void find_robots(const Sight& sight, const DetectorOptions& options, GroundGrid& grid, std::vector<SeenRobot>& robots);

}  // namespace robot::truth
