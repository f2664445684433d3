// A thread that wakes the readers of queues, so that writers do not have to.
#pragma once

#include <thread>
#include <vector>

#include "robot/core/clock.h"
#include "robot/core/lock.h"
#include "robot/logging/streams/version_queue.h"

namespace robot::logging {

/// A thread that calls ring() on each of its queues every kPeriodNs. It sleeps while it has no queue.
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

  void add(VersionQueue& queue);

  /// Removes `queue`. After the return no ring() of it is running and none follows.
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
