// Memory of images that returns to the system.
#pragma once

#include <malloc.h>

namespace robot::app {

/// Makes allocations of half a megabyte and more return to the system when they are freed; a 640x480 image has 600 kB. By
/// default the C library of a 64-bit program keeps the peak of each thread that allocated images: a robot's process then
/// took twice the memory. Called once, before other threads begin.
inline void give_images_back() { mallopt(M_MMAP_THRESHOLD, 512 * 1024); }

}  // namespace robot::app
