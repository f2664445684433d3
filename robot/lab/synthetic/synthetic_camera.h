// The upper camera of the synthetic robot: its pose and its image.
#pragma once

#include <array>
#include <optional>
#include <string>

#include "robot/lab/synthetic/synthetic_world.h"

namespace robot::lab::synthetic {

struct Vector {
  double x = 0, y = 0, z = 0;
};

/// A matrix, row by row.
using Rotation = std::array<double, 9>;

Rotation operator*(const Rotation& a, const Rotation& b);
Vector operator*(const Rotation& a, const Vector& b);

/// A camera in a frame. The columns of `rotation` are its axes right, down, forward.
struct Camera {
  Rotation rotation;
  Vector position;  // [m]
  int width = 0, height = 0;
  double focal = 0;  // [px] focal length; the optical axis is in the middle of the image

  /// A place in the image plane [px], also outside the image, and the distance along the optical axis [m].
  struct Pixel {
    double u, v, depth;
  };

  /// Projects a point of that frame. Returns nothing if it is not in front of the camera.
  std::optional<Pixel> project(const Vector& point) const;

  /// Returns whether `pixel` is at least `margin` [px] inside the image.
  bool shows(const Pixel& pixel, double margin) const;
};

/// The angles of the robot's head and torso [rad].
struct Bearing {
  double head_yaw = 0, head_pitch = 0, torso_roll = 0, torso_pitch = 0;
};

/// Returns the upper camera in the robot's frame.
Camera camera_in_robot(const Bearing& bearing, int width, int height);

/// Returns the upper camera in the frame in which the robot stands at `position`, with `heading`.
Camera moved(const Camera& camera_in_robot, Point position, double heading);

/// Draws the image of a camera in the frame `field` at time `t`, as YUYV.
std::string draw(const Camera& camera, double t);

}  // namespace robot::lab::synthetic
