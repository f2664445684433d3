// Wakes readers, so that writers need not.
#pragma once

#include <thread>
#include <vector>

#include "robot/core/clock.h"
#include "robot/core/lock.h"
#include "robot/logging/streams/version_queue.h"

namespace robot::logging {

/// Rings at the queues it knows every few milliseconds, on a thread of its own; sleeps while it knows none.
/// One thread that wakes up so often costs less than all writers waking all readers for each version: a robot's thread
/// that writes makes no system call. Any thread.
class Bell {
 public:
  static constexpr std::uint64_t kPeriodNs = 4 * kMillisecond;

  Bell() = default;
  ~Bell();
  Bell(const Bell&) = delete;
  Bell& operator=(const Bell&) = delete;

  void add(VersionQueue& queue);

  /// After return `queue` is not being rung at and will not be again.
  void remove(VersionQueue& queue);

 private:
  void run();

  Mutex lock_;
  Condition changed_;
  std::vector<VersionQueue*> queues_;
  bool ended_ = false;
  std::thread thread_;  // starts with the first queue
};

}  // namespace robot::logging
