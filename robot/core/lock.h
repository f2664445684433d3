// Locks with priority inheritance: the holder runs with the priority of the thread that waits for it. So a real-time
// thread never waits for a preempted low-priority thread that holds the lock.
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

/// A condition variable for `Mutex` that uses the monotonic clock: a step of the system clock does not disturb it.
class Condition {
 public:
  Condition();
  ~Condition();
  Condition(const Condition&) = delete;
  Condition& operator=(const Condition&) = delete;

  /// Waits until it is notified; may return without a notification. The caller holds `mutex`.
  void wait(Mutex& mutex);

  /// Waits until it is notified or monotonic_ns() reaches `deadline_ns`; may return earlier without a notification.
  void wait_until(Mutex& mutex, std::uint64_t deadline_ns);

  /// Wakes one waiting thread. Costs no system call while no thread waits.
  void notify_one();
  void notify_all();

 private:
  pthread_cond_t condition_;
};

}  // namespace robot
