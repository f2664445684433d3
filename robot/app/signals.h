// The signals that end a process: SIGINT and SIGTERM.
#pragma once

#include <csignal>

namespace robot::app {

/// Blocks SIGINT and SIGTERM, so that only Runtime::run() takes them. Call it before other threads start; they inherit
/// it.
inline void block_end_signals() {
  sigset_t ends;
  sigemptyset(&ends);
  sigaddset(&ends, SIGINT);
  sigaddset(&ends, SIGTERM);
  pthread_sigmask(SIG_BLOCK, &ends, nullptr);
}

}  // namespace robot::app
