// Pictures as JPEG.
#pragma once

#include <string>

#include "robot/truth/tags/picture.h"

namespace tests {

/// Returns the JPEG of a picture, 4:2:2.
std::string jpeg_of(const robot::truth::tags::Picture& picture, int quality);

/// Returns the picture after compression as a JPEG.
robot::truth::tags::Picture as_jpeg(const robot::truth::tags::Picture& picture, int quality);

}  // namespace tests
