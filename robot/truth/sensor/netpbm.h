// Images of the Netpbm family: PGM and PPM, binary.
#pragma once

#include <string_view>

#include "robot/core/result.h"
#include "robot/truth/sensor/image.h"

namespace robot::truth {

/// Reads a PGM with 16 bits per pixel, the most significant byte first as the format says.
Result<GreyImage> read_pgm(std::string_view bytes);

/// Reads an image that fakenect-record wrote. It has the header of a PGM, but the least significant byte comes first.
Result<GreyImage> read_fakenect_pgm(std::string_view bytes);

/// Reads a PPM with 8 bits per colour.
Result<ColourImage> read_ppm(std::string_view bytes);

}  // namespace robot::truth
