// Threads that stay out of the way of the robot's own.
#pragma once

#include <string_view>

namespace robot {

/// Names the calling thread; 15 characters are shown.
void name_thread(std::string_view name);

/// Names the calling thread and lowers its priority to nice 10: it runs when nobody else wants to.
void become_background_thread(std::string_view name);

}  // namespace robot
