// Versions on their way from a writer, who must not wait, to a thread that may.
#pragma once

#include <cstddef>
#include <cstdint>
#include <deque>
#include <optional>

#include "robot/core/lock.h"
#include "robot/memory/channel.h"

namespace robot::logging {

/// How long versions may gather before their reader is woken.
struct Patience {
  std::uint64_t time_ns = 0;
  std::size_t bytes = 0;  // so many end it
};

/// A queue bounded in bytes: when it is full the oldest make room for the newest and are counted.
/// One version larger than the bound still passes, alone.
///
/// To wake a thread is by far the dearest part of a write, and the thread may push the writer off its processor.
/// With `Patience` a write wakes nobody: somebody else calls ring() every now and then, see Bell.
class VersionQueue final : public memory::Listener {
 public:
  explicit VersionQueue(std::size_t max_bytes, std::optional<Patience> patience = {})
      : max_bytes_(max_bytes), patience_(patience) {}

  /// Puts in `version`; without patience wakes the reader. Does not wait. Any thread.
  void on_version(const memory::VersionPtr& version) override;

  /// Wakes the reader if the patience is over. Any thread.
  void ring(std::uint64_t now_ns);

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
  const std::optional<Patience> patience_;
  mutable Mutex lock_;
  Condition filled_;
  std::deque<memory::VersionPtr> versions_;
  std::size_t bytes_ = 0;
  std::uint64_t noticed_ns_ = 0;  // when ring() first saw what waits; 0: not yet
  std::uint64_t dropped_ = 0;
  bool closed_ = false;
};

}  // namespace robot::logging
