// One picture of an ordinary camera.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

namespace robot::truth::tags {

struct PictureSize {
  int width = 0, height = 0;  // [px]
  friend bool operator==(const PictureSize&, const PictureSize&) = default;
};

/// A colour picture, rows from the top without padding. Pixels as in robot/truth/frame/depth_frame.h.
struct Picture {
  PictureSize size;
  std::vector<std::uint8_t> rgb;  // 3 bytes per pixel
  std::uint64_t capture_ns = 0;   // [ns since the epoch] the exposure, not the arrival
};

/// Returns the brightness of all pixels, 1 byte each (BT.601).
std::vector<std::uint8_t> grey_of(const Picture& picture);

/// Returns an empty picture of this size: black.
inline Picture black_picture(PictureSize size) {
  return {size,
          std::vector<std::uint8_t>(3 * static_cast<std::size_t>(size.width) * static_cast<std::size_t>(size.height)),
          0};
}

}  // namespace robot::truth::tags
