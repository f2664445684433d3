#include "robot/truth/synthetic/disparity_noise.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>

#include "robot/truth/synthetic/random_bits.h"

namespace robot::truth {
namespace {

constexpr std::size_t kTableWidth = 1024, kTableHeight = 512;  // powers of two, whose remainders are fast

/// Returns independent numbers of mean 0 and deviation 1.

std::vector<float> white_noise() {
  std::vector<float> noise(kTableWidth * kTableHeight);
  std::mt19937 random(1);
  const auto uniform = [&] { return (static_cast<double>(random()) + 0.5) / 4294967296.; };
  for (std::size_t i = 0; i < noise.size(); i += 2) {
    // Box and Muller
    const double length = std::sqrt(-2 * std::log(uniform())), angle = 2 * std::numbers::pi * uniform();
    noise[i] = static_cast<float>(length * std::cos(angle));
    noise[i + 1] = static_cast<float>(length * std::sin(angle));
  }
  return noise;
}

/// Returns the sums of three neighbours, `step` apart, in units of their deviation. The table's end continues at its start.
std::vector<float> sums_of_three(const std::vector<float>& noise, std::size_t step) {
  std::vector<float> sums(noise.size());
  for (std::size_t i = 0; i < noise.size(); ++i)
    sums[i] = (noise[i] + noise[(i + step) % noise.size()] + noise[(i + 2 * step) % noise.size()]) / std::sqrt(3.F);
  return sums;
}

/// One row of a scene and its neighbours.
struct Row {
  const float *above, *here, *below;
  int width;

  /// Reports whether a neighbour is more than 0.08 m nearer or farther.
  bool edge(int column) const {
    const float z = here[column], left = here[std::max(column - 1, 0)], right = here[std::min(column + 1, width - 1)];
    const float most =
        std::max({std::abs(left - z), std::abs(right - z), std::abs(above[column] - z), std::abs(below[column] - z)});
    return most > 0.08F;
  }
};

/// The measurement of single depths.
class Meter {
 public:
  Meter(const DepthFrame& frame, double depth_scale)
      : disparity_(static_cast<float>(frame.intrinsics.focal_x * frame.intrinsics.baseline)),
        eighths_(8 * disparity_),
        steps_(static_cast<float>(1 / (frame.unit * depth_scale))) {}

  /// Returns the disparity at a depth [px].
  float disparity(float z) const { return disparity_ / z; }

  /// Returns a depth with an error of `noise` standard deviations, as the image has it.
  std::uint16_t measured(float z, float noise, float edge_noise) const {
    float noisy = z + static_cast<float>(DepthNoise::deviation(static_cast<double>(z))) * noise + edge_noise;
    if (disparity_ > 0) noisy = eighths_ / std::max(1.F, std::floor(eighths_ / noisy + 0.5F));
    return static_cast<std::uint16_t>(std::min(noisy * steps_ + 0.5F, 65535.F));
  }

 private:
  float disparity_;  // [px m] of a thing, times its depth
  float eighths_;    // the same in eighths of a pixel
  float steps_;      // of the image's values in a true metre
};

/// Returns the chance of a dropout, of 65536.
std::uint32_t chance_of_dropout(float z, bool edge) {
  return static_cast<std::uint32_t>(65536 * (edge ? 0.4F : 0.02F + 0.02F * std::max(0.F, z - 4)));
}

/// Writes one row of the image. `noise` repeats after kTableWidth values from its start; the first column is `shift` in it.
void measure_row(const Row& row, const Meter& meter, const float* noise, std::size_t shift, RandomBits& bits,
                 std::uint16_t* depth) {
  constexpr float kNearest = 0.5F, kFarthest = 8;  // [m]
  float shadow_end = -kFar;                        // [px] where the projector's light of the nearest thing so far falls
  for (int column = 0; column < row.width; ++column) {
    const float z = row.here[column];
    const float light = static_cast<float>(column) + meter.disparity(z);
    const bool shadow = light < shadow_end - 0.5F;
    shadow_end = std::max(shadow_end, light);
    const bool edge = row.edge(column);
    const std::uint32_t chance = bits.next();
    depth[column] = 0;
    if (shadow || z > kFarthest || z < kNearest || chance < chance_of_dropout(z, edge)) continue;
    const std::size_t place = (shift + static_cast<std::size_t>(column)) % kTableWidth;
    const float edge_noise = edge ? 0.02F * noise[(place + kTableWidth / 2) % kTableWidth] : 0;
    depth[column] = meter.measured(z, noise[place], edge_noise);
  }
}

}  // namespace

DisparityNoise::DisparityNoise() : correlated_(sums_of_three(sums_of_three(white_noise(), 1), kTableWidth)) {}

void DisparityNoise::measure(const Cast& cast, double depth_scale, std::uint64_t number, DepthFrame& frame) const {
  const auto width = static_cast<std::size_t>(frame.intrinsics.width);
  const auto height = static_cast<std::size_t>(frame.intrinsics.height);
  const Meter meter(frame, depth_scale);
  RandomBits bits(number);
  const std::size_t shift = bits.next() % kTableWidth, first_row = bits.next() % kTableHeight;
  frame.depth.resize(width * height);
  for (std::size_t y = 0; y < height; ++y) {
    const float* const here = &cast.depth[y * width];
    const Row row{y > 0 ? here - width : here, here, y + 1 < height ? here + width : here, static_cast<int>(width)};
    const float* const noise = &correlated_[(first_row + y) % kTableHeight * kTableWidth];
    measure_row(row, meter, noise, shift, bits, &frame.depth[y * width]);
  }
}

}  // namespace robot::truth
