// The depth image of one sensor at one moment.
#pragma once

#include <cstdint>
#include <vector>

namespace robot::truth {

/// The pinhole of a depth image. Pixels as in proto/foresight/camera.proto: the origin is the image's top left corner, so
/// the centre of the first pixel is (0.5, 0.5).
struct Intrinsics {
  int width = 640, height = 480;            // [px]
  double focal_x = 575.8, focal_y = 575.8;  // [px] Kinect v1 (shared/facts/ground_truth.md)
  double centre_x = 320, centre_y = 240;    // [px] of the optical axis
  double baseline = 0.075;                  // [m] between projector and camera; 0: the sensor measures no disparity
  friend bool operator==(const Intrinsics&, const Intrinsics&) = default;
};

/// One depth image, rows from the top without padding. Frame `sensor`: +x right in the image, +y down, +z forward.
/// A depth is a point's z, not its distance.
struct DepthFrame {
  Intrinsics intrinsics;             // of this image; width and height are its size
  double unit = 0.001;               // [m] of one step of `depth`
  std::vector<std::uint16_t> depth;  // width * height; 0: not measured
  std::vector<std::uint8_t> rgb;     // 3 bytes per pixel, of the same pinhole; empty: the sensor has no colour
  std::uint64_t capture_ns = 0;      // [ns since the epoch] the exposure, not the arrival
};

/// The noise of a depth measurement, by which all thresholds of the detection scale.
/// Source: Nguyen, Izadi, Lovell 2012, checked on real planes up to 2.4 m (shared/facts/ground_truth.md section 3).
struct DepthNoise {
  /// Returns the distance between two neighbouring values of the sensor [m] at depth `z` [m]: an eighth of a pixel of
  /// disparity. 0 for a sensor without disparity.
  static double step(const Intrinsics& intrinsics, double z) {
    return intrinsics.baseline > 0 ? z * z / (8 * intrinsics.focal_x * intrinsics.baseline) : 0;
  }
  /// Returns one standard deviation of a depth [m] at depth `z` [m], without the rounding to steps.
  static double deviation(double z) { return 0.0012 + 0.0019 * (z - 0.4) * (z - 0.4); }
};

}  // namespace robot::truth
