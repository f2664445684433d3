// Time: nanoseconds since the epoch that never run backwards.
#pragma once

#include <atomic>
#include <cstdint>

namespace robot {

inline constexpr std::uint64_t kSecond = 1'000'000'000;   // [ns]
inline constexpr std::uint64_t kMillisecond = 1'000'000;  // [ns]

/// Returns the monotonic clock of this machine [ns since some start]. Any thread.
std::uint64_t monotonic_ns();

/// Returns the system clock of this machine [ns since the epoch]; it may be stepped at any time. Any thread.
std::uint64_t system_ns();

/// Returns the CPU time that the calling thread has used [ns]. Any thread.
std::uint64_t thread_cpu_ns();

/// The time base of one robot's memory: its capture times and the server's Time frames use it.
class Clock {
 public:
  virtual ~Clock() = default;

  /// Returns the time [ns since the epoch]. It never decreases while data are live. Any thread.
  virtual std::uint64_t now_ns() const = 0;
};

/// Live time: the monotonic clock plus one offset to the epoch, fixed when the clock is made.
/// A step of the system clock therefore never tears a recording.
class SessionClock final : public Clock {
 public:
  /// Takes the offset from the two clocks of this machine at this moment.
  SessionClock() : SessionClock(system_ns() - monotonic_ns()) {}

  /// Uses a given offset [ns], for tests.
  explicit SessionClock(std::uint64_t epoch_offset_ns) : epoch_offset_ns_(epoch_offset_ns) {}

  std::uint64_t now_ns() const override { return monotonic_ns() + epoch_offset_ns_; }

  /// Returns the offset that is added to the monotonic clock [ns].
  std::uint64_t epoch_offset_ns() const { return epoch_offset_ns_; }

 private:
  std::uint64_t epoch_offset_ns_;
};

/// Time that the caller moves: in tests, and in playback between two records.
class ManualClock final : public Clock {
 public:
  explicit ManualClock(std::uint64_t now_ns = 0) : now_ns_(now_ns) {}

  std::uint64_t now_ns() const override { return now_ns_.load(std::memory_order_acquire); }

  /// Sets the time to `now_ns`. Any thread.
  void set(std::uint64_t now_ns) { now_ns_.store(now_ns, std::memory_order_release); }

 private:
  std::atomic<std::uint64_t> now_ns_;
};

}  // namespace robot
