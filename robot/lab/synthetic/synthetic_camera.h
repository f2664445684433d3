// The upper camera of the synthetic robot: where it is, what it sees.
#pragma once

#include <array>
#include <optional>
#include <string>

#include "robot/lab/synthetic/synthetic_world.h"

namespace robot::lab::synthetic {

struct Vector {
  double x = 0, y = 0, z = 0;
};

/// Row by row.
using Rotation = std::array<double, 9>;

Rotation operator*(const Rotation& a, const Rotation& b);
Vector operator*(const Rotation& a, const Vector& b);

/// A camera in some frame: axes right, down, forward are the columns of `rotation`.
struct Camera {
  Rotation rotation;
  Vector position;  // [m]
  int width = 0, height = 0;
  double focal = 0;  // [px] the optical axis is in the image's middle

  /// Where a point of that frame appears [px]; nothing if it is not in front of the camera, image or not.
  struct Pixel {
    double u, v, depth;
  };
  std::optional<Pixel> project(const Vector& point) const;

  /// True if `pixel` is at least `margin` [px] inside the image.
  bool shows(const Pixel& pixel, double margin) const;
};

/// How the robot holds its head and leans [rad].
struct Bearing {
  double head_yaw = 0, head_pitch = 0, torso_roll = 0, torso_pitch = 0;
};

/// The upper camera in the robot's frame.
Camera camera_in_robot(const Bearing& bearing, int width, int height);

/// The same in the frame in which the robot stands at `position`, looking along `heading`.
Camera moved(const Camera& camera_in_robot, Point position, double heading);

/// The image of a camera in the frame `field` at time `t`, as YUYV.
std::string draw(const Camera& camera, double t);

}  // namespace robot::lab::synthetic
