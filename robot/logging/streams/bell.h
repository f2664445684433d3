// A thread that wakes the readers of queues, so that writers do not have to.
#pragma once

#include <cstdint>
#include <thread>
#include <vector>

#include "robot/core/clock.h"
#include "robot/core/lock.h"

namespace robot::logging {

/// A reader of queues that sleeps until it is woken.
class Sleeper {
 public:
  virtual ~Sleeper() = default;

  /// Wakes the reader if its queues are due at `now_ns` [monotonic]. Must return at once.
  virtual void ring(std::uint64_t now_ns) = 0;
};

/// A thread that calls ring() on each sleeper every kPeriodNs. It waits while it has no sleeper. If the system refuses the
/// thread, it is tried again with each further sleeper and by start_missing_thread().
///
/// One thread with this period costs less than writers that wake a reader for each version: a robot's thread that
/// writes makes no system call. Any thread.
class Bell {
 public:
  static constexpr std::uint64_t kPeriodNs = 4 * kMillisecond;

  Bell() = default;
  ~Bell();
  Bell(const Bell&) = delete;
  Bell& operator=(const Bell&) = delete;

  void add(Sleeper& sleeper);

  /// Starts the thread if the system refused it before.
  void start_missing_thread();

  /// Removes `sleeper`. After the return no ring() of it is running and none follows.
  void remove(Sleeper& sleeper);

 private:
  void start();
  void run();

  Mutex lock_;
  Condition changed_;
  std::vector<Sleeper*> sleepers_;
  bool ended_ = false;
  std::thread thread_;  // starts with the first sleeper
};

}  // namespace robot::logging
