// Locks whose holder inherits the priority of whoever waits: a real-time thread is never kept waiting
// by a low-priority one that was pushed off the processor while it held the lock.
#pragma once

#include <pthread.h>

#include <cstdint>

namespace robot {

/// A mutex with priority inheritance. Use with std::lock_guard and std::unique_lock.
class Mutex {
 public:
  Mutex();
  ~Mutex();
  Mutex(const Mutex&) = delete;
  Mutex& operator=(const Mutex&) = delete;

  void lock();
  void unlock();
  bool try_lock();

 private:
  friend class Condition;
  pthread_mutex_t mutex_;
};

/// A condition variable for `Mutex`, timed by the monotonic clock: a stepping system clock does not disturb it.
class Condition {
 public:
  Condition();
  ~Condition();
  Condition(const Condition&) = delete;
  Condition& operator=(const Condition&) = delete;

  /// Waits until woken; may wake without reason. `mutex` is held by the caller.
  void wait(Mutex& mutex);

  /// Waits until woken or until monotonic_ns() reaches `deadline_ns`; may wake without reason.
  void wait_until(Mutex& mutex, std::uint64_t deadline_ns);

  /// Wakes one waiting thread. Costs no system call while nobody waits.
  void notify_one();
  void notify_all();

 private:
  pthread_cond_t condition_;
};

}  // namespace robot
