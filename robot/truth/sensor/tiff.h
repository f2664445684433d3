// TIFF images, by libtiff.
#pragma once

#include <string_view>

#include "robot/core/result.h"
#include "robot/truth/sensor/image.h"

namespace robot::truth {

/// Reads the first image of a TIFF: 16 bits of grey per pixel, in strips, with any compression and order of bytes.
Result<GreyImage> read_tiff(std::string_view bytes);

}  // namespace robot::truth
