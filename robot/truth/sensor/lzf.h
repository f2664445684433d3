// LZF, the compression of PCL's depth recordings.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

#include "robot/core/result.h"

namespace robot::truth {

/// Returns the `size` bytes that `packed` describes. Returns an Error if it describes fewer or more.
/// Format: Marc Lehmann's liblzf.
Result<std::string> unpack_lzf(std::string_view packed, std::size_t size);

}  // namespace robot::truth
