// The fixed camera of a label file: from pixels to the ground, and its fit to the boxes of robots.
#pragma once

#include <optional>
#include <vector>

#include "robot/core/result.h"
#include "robot/lab/import/label_rows.h"

namespace robot::lab::labels {

/// A point on the ground [m]: below the camera is (0, 0), +x is ahead of the camera, +y left of it.
struct Ground {
  double x = 0, y = 0;
};

/// An action camera with a fish-eye lens, which stands still beside the field. Model of the lens: B-Human's VideoAnalysis
/// (2019) describes it for such cameras.
struct Camera {
  double focal_px = 920;
  double height = 2.3;  // [m] above the ground
  double pitch = 0.5;   // [rad] > 0: it looks down
  double roll = 0;      // [rad]
  double lens = 1;      // scale of the radial term 0.18 r² + 0.15 r⁴ + 0.10 r⁶; 0: no distortion
  bool super_view =
      false;  // the video is stretched: by 1.25 in the middle, and up to 1.33 times less or more at the edges

  /// Returns the point seen at a pixel, if it is `above` [m] the ground. A pixel at the horizon or above is far away.
  Ground at(double x_px, double y_px, double above = 0) const;
  /// Returns the distance of a point from the camera along the ground [m].
  double distance_at(double x_px, double y_px, double above = 0) const;
};

/// The error of a camera, as the difference between the places of robots' feet and heads: a head is 0.54 m above the feet.
struct CameraError {
  double share = 0;   // median of |difference| / distance from the camera
  double metres = 0;  // [m] median of |difference|
};

/// Returns the boxes of robots that stand whole and upright in the image, of every tenth frame.
std::vector<Box> upright_boxes(const std::vector<Frame>& frames);

/// Fits a camera to boxes of upright robots. Returns an Error for fewer than 50 boxes.
Result<Camera> fit_camera(const std::vector<Box>& upright);

/// Measures the error of a camera on boxes that it need not have been fitted to.
CameraError error_of(const Camera& camera, const std::vector<Box>& upright);

/// Returns the median, or 0 without values.
double median(std::vector<double> values);

}  // namespace robot::lab::labels
