// Images as their files hold them, before they become depth images.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string_view>
#include <vector>

#include "robot/core/result.h"

namespace robot::truth {

inline constexpr int kMaxSide = 4096;  // [px]
/// The greatest file of one image: 16-bit grey, or 8-bit colour, that its compression made no smaller.
inline constexpr std::size_t kMaxImageBytes = std::size_t{4} * kMaxSide * kMaxSide;

/// A 16-bit grey image, rows from the top without padding.
struct GreyImage {
  int width = 0, height = 0;          // [px]
  std::vector<std::uint16_t> values;  // width * height
};

/// An 8-bit colour image, rows from the top without padding.
struct ColourImage {
  int width = 0, height = 0;      // [px]
  std::vector<std::uint8_t> rgb;  // 3 * width * height
};

/// Returns an Error unless both sides are 1 .. kMaxSide.
Result<void> check_size(std::uint64_t width, std::uint64_t height);

/// Returns 16-bit values from bytes of which the most significant one comes first.
std::vector<std::uint16_t> from_big_endian(std::string_view bytes);

/// Returns 16-bit values from bytes of which the least significant one comes first.
std::vector<std::uint16_t> from_little_endian(std::string_view bytes);

}  // namespace robot::truth
