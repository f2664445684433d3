// The part of the world that a camera shows.
#pragma once

#include <array>
#include <cstdint>
#include <optional>

#include "proto/foresight/camera.pb.h"

namespace robot::fit {

/// A camera at one moment. Frame: robot, see proto/foresight/camera.proto.
struct View {
  std::uint64_t capture_ns = 0;
  std::array<double, 9> rotation{};              // robot_from_camera, row by row
  double x = 0, y = 0, z = 0;                    // [m] the optical centre
  double left = 0, right = 0, up = 0, down = 0;  // [rad] from the optical axis to the borders, > 0
  double bearing = 0, tilt = 0;                  // [rad] of the optical axis, to the left and downwards
  double speed = 0;                              // [rad/s] turning rate of the optical axis since the image before

  /// The way from a point to the nearest borders, < 0 outside.
  struct Inside {
    double across = 0, upright = 0;  // [rad]
  };

  /// Returns where a point [m, robot] is in the view. That is the part that both the image and the simulator's view show: the
  /// simulator's ends at bearings and elevations, so they differ in the corners.
  Inside inside(double point_x, double point_y, double point_z) const;
};

/// Returns the view of a camera, or nothing if its matrix is damaged.
std::optional<View> view_of(const foresight::CameraMatrix& matrix, std::uint64_t capture_ns);

/// Returns the angle between two optical axes [rad].
double angle_between(const View& one, const View& other);

}  // namespace robot::fit
