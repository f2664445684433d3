// A behaviour in a process of its own, in lock step: the game waits for each answer (sim/guest/wire.h).
#pragma once

#include <memory>
#include <string>

#include "sim/guest/guest.h"

namespace sim::guest {

/// Opens the shell command `command`. Starts it once to check its greeting.
robot::Result<std::shared_ptr<const GuestFactory>> open_pipe(const std::string& name, const std::string& command);

}  // namespace sim::guest
