// The image of a scene without noise: the depth and the material of each pixel.
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <vector>

#include "robot/truth/frame/depth_frame.h"

namespace robot::truth {

/// The surface that a pixel shows, which gives its colour.
enum class Material : std::uint8_t { nothing, carpet, line, wall, post, robot, person, orange, white, black, patches };

/// An exact image, rows from the top.
struct Cast {
  std::vector<float> depth;        // [m]; kFar: nothing is there
  std::vector<Material> material;  // of each pixel
};
inline constexpr float kFar = 1e9F;  // [m]

/// All points within `radius` of the line between two points. Both points are the same for a ball.
/// All bodies are made of capsules, because one ray test is enough for all of them.
struct Capsule {
  Eigen::Vector3f from, to;  // [m]
  float radius;              // [m]
  Material material;         // `patches`: black and white in turn, in eight parts about `from`
};

/// Draws a capsule, given in the frame `sensor`, into the image where it is nearer than anything drawn before. Leaves out
/// a capsule that comes nearer to the sensor's plane than 0.05 m.
void draw(const Capsule& in_sensor, const Intrinsics& intrinsics, Cast& cast);

}  // namespace robot::truth
