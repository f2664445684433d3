// PNG images, by libpng.
#pragma once

#include <string_view>

#include "robot/core/result.h"
#include "robot/truth/sensor/image.h"

namespace robot::truth {

/// Reads a PNG with 16 bits of grey per pixel. The values stay as they are: no gamma, no profile.
Result<GreyImage> read_png(std::string_view bytes);

}  // namespace robot::truth
