// A behaviour in a process of its own, in lock step: it is asked, and the game waits for the answer (sim/guest/wire.h).
#pragma once

#include <memory>
#include <string>

#include "sim/guest/guest.h"

namespace sim::guest {

/// `command` is the shell's; it is started once to see whether it answers.
robot::Result<std::shared_ptr<const GuestFactory>> open_pipe(const std::string& name, const std::string& command);

}  // namespace sim::guest
