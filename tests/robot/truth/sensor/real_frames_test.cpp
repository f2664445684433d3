// Images of real sensors: every reader, and the noise of real planes against the noise model.
#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "robot/truth/sensor/open_source.h"
#include "tests/support/real_data.h"

namespace robot::truth {
namespace {

/// Expects an image of the source, and returns it.
DepthFrame next_of(DepthSource& source) {
  Result<std::optional<DepthFrame>> frame = source.next();
  EXPECT_TRUE(frame) << frame.error();
  EXPECT_TRUE(frame && *frame);
  return frame && *frame ? **std::move(frame) : DepthFrame{};
}

std::unique_ptr<DepthSource> opened(const std::string& kind, const std::filesystem::path& folder) {
  Result<std::unique_ptr<DepthSource>> source = open_source(kind + ":" + folder.string());
  EXPECT_TRUE(source) << source.error();
  return source ? *std::move(source) : nullptr;
}

constexpr int kWindow = 42;  // [px]
constexpr int kEach = 3;     // every third pixel of every third row is enough

/// A window of an image that shows a plane.
struct PlaneWindow {
  double depth = 0, deviation = 0;  // [m] the mean depth, and the root mean square of the distances from the plane
};

struct Pixel {
  Eigen::Vector3d place;  // column, row, 1
  double depth;           // [m]
};

std::vector<Pixel> measured_pixels(const DepthFrame& frame, int left, int top) {
  std::vector<Pixel> pixels;
  for (int row = top; row < top + kWindow; row += kEach)
    for (int column = left; column < left + kWindow; column += kEach) {
      const auto at = static_cast<std::size_t>(row * frame.intrinsics.width + column);
      if (frame.depth[at])
        pixels.push_back({Eigen::Vector3d(column - left, row - top, 1), frame.unit * frame.depth[at]});
    }
  return pixels;
}

/// Returns the pixels that are at most four deviations of the noise model away from the plane.
std::vector<Pixel> near_plane(const std::vector<Pixel>& pixels, const Eigen::Vector3d& plane) {
  std::vector<Pixel> near;
  for (const Pixel& pixel : pixels)
    if (std::abs(pixel.depth - 1 / plane.dot(pixel.place)) < 4 * DepthNoise::deviation(pixel.depth))
      near.push_back(pixel);
  return near;
}

/// Fits a plane, whose inverse depth is a linear function of the pixel.
Eigen::Vector3d plane_through(const std::vector<Pixel>& pixels) {
  Eigen::Matrix3d squares = Eigen::Matrix3d::Zero();
  Eigen::Vector3d products = Eigen::Vector3d::Zero();
  for (const Pixel& pixel : pixels) {
    squares += pixel.place * pixel.place.transpose();
    products += pixel.place / pixel.depth;
  }
  return squares.ldlt().solve(products);
}

/// Returns nothing for a window that shows an edge, a curved surface or pixels without a depth.
std::optional<PlaneWindow> plane_window(const DepthFrame& frame, int left, int top) {
  const std::vector<Pixel> pixels = measured_pixels(frame, left, top);
  const std::size_t enough = kWindow / kEach * kWindow / kEach * 95 / 100;
  std::vector<Pixel> near = pixels;
  Eigen::Vector3d plane;
  for (int i = 0; i < 4 && near.size() >= enough; ++i) {
    plane = plane_through(near);
    near = near_plane(pixels, plane);
  }
  if (near.size() < enough) return std::nullopt;
  PlaneWindow window;
  double squares = 0;
  for (const Pixel& pixel : near) {
    const double distance = pixel.depth - 1 / plane.dot(pixel.place);
    window.depth += pixel.depth / static_cast<double>(near.size());
    squares += distance * distance;
  }
  window.deviation = std::sqrt(squares / static_cast<double>(near.size()));
  return window;
}

/// Compares the median window of each slice of 0.3 m with the noise model. Returns the number of slices.
///
/// The noise of the windows agrees with deviation() alone: Nguyen's figure contains the rounding to steps. Nearer than 0.9 m
/// the model is a third above the windows; farther than 3.6 m these images show too few planes.
int compare_with_noise_model(const DepthFrame& frame) {
  std::map<int, std::vector<double>> ratios;
  for (int top = 0; top + kWindow <= frame.intrinsics.height; top += kWindow / 2)
    for (int left = 0; left + kWindow <= frame.intrinsics.width; left += kWindow / 2)
      if (const auto window = plane_window(frame, left, top))
        ratios[static_cast<int>(window->depth / 0.3)].push_back(window->deviation /
                                                                DepthNoise::deviation(window->depth));
  int slices = 0;
  for (auto& [slice, values] : ratios) {
    if (slice < 3 || slice > 11 || values.size() < 10) continue;
    const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
    std::nth_element(values.begin(), middle, values.end());
    EXPECT_NEAR(*middle, 1, 0.2) << values.size() << " windows " << 0.3 * slice << " m away";
    ++slices;
  }
  return slices;
}

TEST(RealFrames, FakenectDeliversARecordingOfAKinect) {
  REAL_DATA_OR_SKIP(path, "depth/fakenect_nyu/INDEX.txt");
  const auto source = opened("fakenect", path.parent_path());
  for (const std::uint64_t capture_ns : {1294851097'453589000u, 1294851097'486922000u}) {
    const DepthFrame frame = next_of(*source);
    EXPECT_EQ(frame.capture_ns, capture_ns);
    EXPECT_EQ(frame.intrinsics, Intrinsics{});
    EXPECT_EQ(std::count(frame.depth.begin(), frame.depth.end(), 0), 640 * 480 - 285001);
    // disparities 839 to 1040
    EXPECT_EQ(*std::max_element(frame.depth.begin(), frame.depth.end()), 6910);
  }
  EXPECT_FALSE(*source->next());
}

TEST(RealFrames, PclzfAndTiffOfTheSameImageAgree) {
  REAL_DATA_OR_SKIP(path, "depth/frame_20121214T142255.814212.xml");
  const DepthFrame pclzf = next_of(*opened("pclzf", path.parent_path()));
  const DepthFrame tiff = next_of(*opened("folder", path.parent_path()));
  EXPECT_EQ(pclzf.depth, tiff.depth);
  EXPECT_EQ(pclzf.depth.size(), 640u * 480);
  EXPECT_EQ(pclzf.capture_ns, tiff.capture_ns);
  EXPECT_EQ(pclzf.intrinsics.focal_x, 525);
  EXPECT_EQ(pclzf.rgb.size(), 3u * 640 * 480);
  EXPECT_GT(std::count_if(pclzf.depth.begin(), pclzf.depth.end(), [](auto depth) { return depth > 0; }), 200'000);
}

TEST(RealFrames, ThePlanesOfARoomHaveTheModelledNoise) {
  REAL_DATA_OR_SKIP(path, "depth/fakenect_nyu/INDEX.txt");
  EXPECT_GE(compare_with_noise_model(next_of(*opened("fakenect", path.parent_path()))), 3);
}

TEST(RealFrames, ThePlanesOfPclsSceneHaveTheModelledNoise) {
  REAL_DATA_OR_SKIP(path, "depth/frame_20121214T142255.814212.xml");
  EXPECT_GE(compare_with_noise_model(next_of(*opened("pclzf", path.parent_path()))), 2);
}

}  // namespace
}  // namespace robot::truth
