// Start, names and priorities of threads. Background threads must not disturb the team's own.
#pragma once

#include <functional>
#include <string_view>
#include <thread>

#include "robot/core/result.h"

namespace robot {

/// Starts `thread`, which must not run yet, with the function `run`. Returns an Error if the system allows no more threads;
/// `purpose` names the thread in it. The only place that starts threads, because std::thread throws.
Result<void> start_thread(std::thread& thread, std::string_view purpose, std::function<void()> run);

/// Sets the name of the calling thread; the system keeps 15 characters.
void name_thread(std::string_view name);

/// Sets the name of the calling thread and lowers its priority to nice 10, so that other threads go first.
void become_background_thread(std::string_view name);

}  // namespace robot
