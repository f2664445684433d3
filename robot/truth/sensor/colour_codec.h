// Files and camera frames to colour images. Pure.
#pragma once

#include <string_view>

#include "robot/core/result.h"
#include "robot/truth/sensor/image.h"

namespace robot::truth {

/// The treatment of a JPEG that is damaged but has an image.
enum class Damage { refused, accepted };

/// Reads a JPEG, PNG or PPM (P6, 8 bits), by its first bytes. Returns an Error for a file that is damaged or cut off.
Result<ColourImage> read_colour(std::string_view bytes);

/// Reads a JPEG. Cheap cameras send JPEGs with stray bytes, so a frame of a camera is read with Damage::accepted.
Result<ColourImage> read_jpeg(std::string_view bytes, Damage damage);

/// Converts a YUYV image without padding: 2 bytes per pixel, full-range BT.601. Returns an Error if the number of bytes is
/// not that of the size.
Result<ColourImage> colour_of_yuyv(std::string_view yuyv, int width, int height);

}  // namespace robot::truth
