// The signals that end a process: SIGINT and SIGTERM.
#pragma once

#include <cstdint>

namespace robot::app {

/// The longest time from the signal to the end of the process [ns]. Only closing a recording may take longer.
inline constexpr std::uint64_t kEndNs = 900'000'000, kEndOfRecordingNs = 10'000'000'000;

/// Takes SIGINT and SIGTERM from now on. After one of them wait_for_end() returns true, and the process should end. If it
/// still runs after kEndNs, because something waits for a disk, a network or a lock, it ends at once with status 0.
/// Call it before other threads start; they inherit the blocked signals. A second call has no effect.
void block_end_signals();

/// Waits for `duration_ns`. Returns true, at once, when the process should end.
bool wait_for_end(std::uint64_t duration_ns);

/// Gives an end that has begun another `duration_ns` from now.
void end_within(std::uint64_t duration_ns);

}  // namespace robot::app
