// Camera images as the Nao delivers them (YUYV) to JPEG and back.
#pragma once

#include <string>
#include <string_view>

#include "robot/core/result.h"

namespace robot::image {

struct JpegOptions {
  int width = 0;     // [px] of the JPEG: the image's own width (also written 0), or half of it
  int quality = 75;  // 1 .. 100
};

/// Encodes the YUYV image `yuyv` as a baseline 4:2:2 JPEG. The image has `width` x `height` [px], 2 bytes per pixel and
/// no gaps between rows. Colour values are full-range BT.601, as in the JPEG standard and from the Nao's cameras. Any
/// thread.
Result<std::string> encode_jpeg(std::string_view yuyv, int width, int height, JpegOptions options = {});

struct YuyvImage {
  int width = 0, height = 0;  // [px]
  std::string yuyv;           // 2 bytes per pixel
};

struct ImageSize {
  int width = 0, height = 0;  // [px]
};

/// Returns the size of the image that decode_jpeg() would return, without decoding it.
Result<ImageSize> size_of_jpeg(std::string_view jpeg);

/// Decodes a JPEG of at most 4096 x 4096 px. It accepts two kinds: an ordinary colour JPEG, and the four-component JPEG
/// of the 2009 B-Human recordings. The latter has the Y U Y V of each pair of pixels as components, so its width counts
/// pairs.
Result<YuyvImage> decode_jpeg(std::string_view jpeg);

}  // namespace robot::image
