// How a process is told to end.
#pragma once

#include <csignal>

namespace robot::app {

/// Keeps SIGINT and SIGTERM for Runtime::run(); to be called before any other thread starts, which then inherits it.
inline void block_end_signals() {
  sigset_t ends;
  sigemptyset(&ends);
  sigaddset(&ends, SIGINT);
  sigaddset(&ends, SIGTERM);
  pthread_sigmask(SIG_BLOCK, &ends, nullptr);
}

}  // namespace robot::app
