// Names and priorities of threads: background threads must not disturb the team's own.
#pragma once

#include <string_view>

namespace robot {

/// Sets the name of the calling thread; the system keeps 15 characters.
void name_thread(std::string_view name);

/// Sets the name of the calling thread and lowers its priority to nice 10, so that other threads go first.
void become_background_thread(std::string_view name);

}  // namespace robot
