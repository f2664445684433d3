#include "robot/truth/sensor/kinect.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <string>

#include "robot/core/text.h"

namespace robot::truth {
namespace {

constexpr double kFocal = 575.8, kBaseline = 0.075;  // [px at 640x480], [m], as in Intrinsics

// The disparity at an infinite depth, and steps per pixel. Source: Konolige and Mihelich, "Technical description of Kinect
// calibration", ROS wiki (kinect_calibration/technical): z = b f / d, d = (1090 - raw) / 8, b = 7.5 cm.
constexpr double kInfinite = 1090, kStepsPerPixel = 8;

// the colour camera, to the right of the depth camera; focal length and distance of OpenNI's nominal frames in ROS
constexpr double kColourFocal = 525, kColourRight = 0.025;  // [px at 640x480], [m]

std::array<std::uint16_t, kNoDisparity + 1> make_depths() {
  std::array<std::uint16_t, kNoDisparity + 1> depths{};
  for (std::size_t disparity = 0; disparity < depths.size(); ++disparity) {
    const double pixels = (kInfinite - static_cast<double>(disparity)) / kStepsPerPixel;
    const double millimetres = std::round(1000 * kBaseline * kFocal / pixels);
    if (pixels > 0 && millimetres < 65000) depths[disparity] = static_cast<std::uint16_t>(millimetres);
  }
  return depths;
}

/// The way from pixels of a depth image to those of the colour image beside it.
struct ColourView {
  const Intrinsics& depth_camera;
  const ColourImage& colour;

  /// Returns the three bytes of the colour at this depth [m] in the pixel, or nullptr outside the colour image.
  const std::uint8_t* at(int column, int row, double depth) const {
    const double focal = kColourFocal * colour.width / 640;
    const double right = (column + 0.5 - depth_camera.centre_x) / depth_camera.focal_x - kColourRight / depth;
    const double down = (row + 0.5 - depth_camera.centre_y) / depth_camera.focal_y;
    const double x = std::floor(colour.width / 2.0 + focal * right);
    const double y = std::floor(colour.height / 2.0 + focal * down);
    if (!(x >= 0 && y >= 0 && x < colour.width && y < colour.height)) return nullptr;
    return &colour.rgb[3 * (static_cast<std::size_t>(y) * static_cast<std::size_t>(colour.width) +
                            static_cast<std::size_t>(x))];
  }
};

}  // namespace

Intrinsics kinect_intrinsics(int width, int height) {
  const double focal = kFocal * width / 640;
  return {.width = width,
          .height = height,
          .focal_x = focal,
          .focal_y = focal,
          .centre_x = width / 2.0,
          .centre_y = height / 2.0,
          .baseline = kBaseline};
}

std::uint16_t depth_of_disparity(std::uint16_t disparity) {
  static const std::array<std::uint16_t, kNoDisparity + 1> depths = make_depths();
  return disparity > kNoDisparity ? std::uint16_t{0} : depths[disparity];
}

Result<DepthFrame> kinect_frame(const GreyImage& disparities, const ColourImage* colour) {
  const auto wrong = std::find_if(disparities.values.begin(), disparities.values.end(),
                                  [](std::uint16_t value) { return value > kNoDisparity; });
  if (wrong != disparities.values.end())
    return Error{formatted("expected disparities of 11 bits (0 to 2047), got %d in pixel %td", *wrong,
                           wrong - disparities.values.begin())};
  DepthFrame frame;
  frame.intrinsics = kinect_intrinsics(disparities.width, disparities.height);
  frame.depth.resize(disparities.values.size());
  std::transform(disparities.values.begin(), disparities.values.end(), frame.depth.begin(), depth_of_disparity);
  if (colour) frame.rgb = registered_colours(frame, *colour);
  return frame;
}

std::vector<std::uint8_t> registered_colours(const DepthFrame& frame, const ColourImage& colour) {
  std::vector<std::uint8_t> rgb(3 * frame.depth.size());
  const ColourView view{frame.intrinsics, colour};
  std::size_t pixel = 0;
  for (int row = 0; row < frame.intrinsics.height; ++row) {
    std::uint16_t depth = 0;
    for (int column = 0; column < frame.intrinsics.width; ++column, ++pixel) {
      if (frame.depth[pixel]) depth = frame.depth[pixel];
      const std::uint8_t* seen = depth ? view.at(column, row, depth * frame.unit) : nullptr;
      if (seen) std::copy(seen, seen + 3, &rgb[3 * pixel]);
    }
  }
  return rgb;
}

}  // namespace robot::truth
