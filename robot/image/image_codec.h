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

/// A baseline 4:2:2 JPEG of the YUYV image `yuyv`: `width` x `height` [px], 2 bytes per pixel, rows without gaps.
/// Colour values are taken as full-range BT.601, as the JPEG standard and the Nao's cameras have them. Any thread.
Result<std::string> encode_jpeg(std::string_view yuyv, int width, int height, JpegOptions options = {});

struct YuyvImage {
  int width = 0, height = 0;  // [px]
  std::string yuyv;           // 2 bytes per pixel
};

struct ImageSize {
  int width = 0, height = 0;  // [px]
};

/// How large the picture is that decode_jpeg() makes of a JPEG, without decoding it.
Result<ImageSize> size_of_jpeg(std::string_view jpeg);

/// The pixels of a JPEG. Two kinds are understood: an ordinary colour JPEG, and the four-component JPEG of the 2009
/// B-Human recordings, whose components are the Y U Y V of each pair of pixels, so that its width counts pairs.
/// At most 4096 x 4096 px.
Result<YuyvImage> decode_jpeg(std::string_view jpeg);

}  // namespace robot::image
