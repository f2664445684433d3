// Versions on their way from a writer, who must not wait, to a thread that may.
#pragma once

#include <cstddef>
#include <cstdint>
#include <deque>

#include "robot/core/lock.h"
#include "robot/memory/channel.h"

namespace robot::logging {

/// A queue bounded in bytes: when it is full the oldest make room for the newest and are counted.
/// One version larger than the bound still passes, alone.
class VersionQueue final : public memory::Listener {
 public:
  explicit VersionQueue(std::size_t max_bytes) : max_bytes_(max_bytes) {}

  /// Puts in `version` and wakes the reader. Does not wait. Any thread.
  void on_version(const memory::VersionPtr& version) override;

  /// The oldest version; waits for one until monotonic_ns() reaches `deadline_ns`, then null.
  /// Null at once when the queue is closed and empty.
  memory::VersionPtr pop(std::uint64_t deadline_ns);

  /// Nothing more is taken in; a waiting pop() returns. What is queued can still be popped. Any thread.
  void close();

  bool closed() const;

  /// How many versions had to make room since the beginning. Any thread.
  std::uint64_t dropped() const;

  /// What waits now [bytes]. Any thread.
  std::size_t queued_bytes() const;

 private:
  const std::size_t max_bytes_;
  mutable Mutex lock_;
  Condition filled_;
  std::deque<memory::VersionPtr> versions_;
  std::size_t bytes_ = 0;
  std::uint64_t dropped_ = 0;
  bool closed_ = false;
};

}  // namespace robot::logging
