#include "robot/app/signals.h"

#include <unistd.h>

#include <csignal>
#include <mutex>
#include <string_view>
#include <thread>

#include "robot/core/clock.h"
#include "robot/core/lock.h"
#include "robot/core/thread.h"

namespace robot::app {
namespace {

struct End {
  Mutex lock;
  Condition changed;
  bool begun = false, watched = false;
  std::uint64_t deadline_ns = 0;  // [monotonic] of an end that has begun
};

/// Returns the only one, which is never destroyed: its thread runs until the process ends.
End& end() {
  static End* const only = new End;
  return *only;
}

sigset_t end_signals() {
  sigset_t ends;
  sigemptyset(&ends);
  sigaddset(&ends, SIGINT);
  sigaddset(&ends, SIGTERM);
  return ends;
}

/// Waits for a signal, and then until the deadline. Takes no lock that others hold for long.
void watch() {
  name_thread("end");
  const sigset_t ends = end_signals();
  int which = 0;
  while (sigwait(&ends, &which) != 0) {
  }
  End& state = end();
  {
    const std::lock_guard guard(state.lock);
    state.begun = true;
    state.deadline_ns = monotonic_ns() + kEndNs;
    state.changed.notify_all();
    while (monotonic_ns() < state.deadline_ns) state.changed.wait_until(state.lock, state.deadline_ns);
  }
  constexpr std::string_view kSentence = "the orderly end takes too long: the process ends at once\n";
  [[maybe_unused]] const ssize_t written = ::write(STDERR_FILENO, kSentence.data(), kSentence.size());
  ::_exit(0);
}

}  // namespace

void block_end_signals() {
  const sigset_t ends = end_signals();
  pthread_sigmask(SIG_BLOCK, &ends, nullptr);
  {
    const std::lock_guard guard(end().lock);
    if (end().watched) return;
    end().watched = true;
  }
  std::thread watching;
  if (const Result<void> started = start_thread(watching, "end", watch); started) return watching.detach();
  // without the thread the signals end the process as they do by default
  pthread_sigmask(SIG_UNBLOCK, &ends, nullptr);
}

bool wait_for_end(std::uint64_t duration_ns) {
  End& state = end();
  const std::uint64_t until_ns = monotonic_ns() + duration_ns;
  const std::lock_guard guard(state.lock);
  while (!state.begun && monotonic_ns() < until_ns) state.changed.wait_until(state.lock, until_ns);
  return state.begun;
}

void end_within(std::uint64_t duration_ns) {
  const std::lock_guard guard(end().lock);
  end().deadline_ns = monotonic_ns() + duration_ns;
  end().changed.notify_all();
}

}  // namespace robot::app
