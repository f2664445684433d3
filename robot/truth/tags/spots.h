// Connected spots of one colour in a picture.
#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <vector>

#include "robot/truth/frame/depth_frame.h"

namespace robot::truth::tags {

/// A range of colours. The default is the orange of the leagues' street-hockey ball.
struct ColourRange {
  double hue_from_deg = 5, hue_to_deg = 40;  // [0..360) red 0, yellow 60, blue 240; 350 to 20 goes over 0
  double least_saturation = 0.5;             // [0..1]
  double least_brightness = 0.2;             // [0..1] of the strongest of red, green and blue
};

/// The middles of all pixels of a spot [px].
using Spot = std::vector<Eigen::Vector2d>;

/// Returns the spots of these colours with at least `fewest` pixels. Pixels that touch at a side or a corner are
/// connected. A spot of more than 40,000 pixels is too large for a ball and is left out.
std::vector<Spot> spots_of_colour(const DepthFrame& picture, const ColourRange& colours, std::size_t fewest);

}  // namespace robot::truth::tags
