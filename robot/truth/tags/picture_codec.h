// Files and camera frames to pictures. Pure.
#pragma once

#include <string_view>

#include "robot/core/result.h"
#include "robot/truth/tags/picture.h"

namespace robot::truth::tags {

inline constexpr int kMostSide = 4096;  // [px]

/// The treatment of a JPEG that is damaged but has a picture.
enum class Damage { refused, accepted };

/// Decodes a JPEG, PNG or PPM (P6, 8 bits) of at most 4096 x 4096 px, by its first bytes. Returns an Error for a file that
/// is damaged or cut off. `capture_ns` is left to the caller.
Result<Picture> decode_picture(std::string_view bytes);

/// Decodes a JPEG. Cheap cameras send JPEGs with stray bytes, so a frame of a camera is decoded with Damage::accepted.
Result<Picture> decode_jpeg_picture(std::string_view bytes, Damage damage);

/// Converts a YUYV image without padding: 2 bytes per pixel, full-range BT.601. Returns an Error if the number of bytes is
/// not that of the size.
Result<Picture> picture_of_yuyv(std::string_view yuyv, PictureSize size);

}  // namespace robot::truth::tags
