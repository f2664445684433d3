// A behaviour in a shared library: sim/guest/foresight_behaviour.h.
#pragma once

#include <memory>
#include <string>

#include "sim/guest/guest.h"

namespace sim::guest {

/// Loads the library at that path, and checks its interface and version.
robot::Result<std::shared_ptr<const GuestFactory>> open_library(const std::string& path);

}  // namespace sim::guest
