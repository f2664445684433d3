// The colours of a depth image.
#pragma once

#include <cstdint>

#include "robot/truth/frame/depth_frame.h"
#include "robot/truth/synthetic/cast.h"

namespace robot::truth {

/// Writes the colours that a sensor shows of `cast`: shifted by a pixel to the right, since no registration is exact. One
/// pixel of 20 of an orange ball has another colour, and one of 100,000 elsewhere is orange. The intrinsics of `frame` are
/// set. Different numbers give different faults.
void paint(const Cast& cast, std::uint64_t number, DepthFrame& frame);

}  // namespace robot::truth
