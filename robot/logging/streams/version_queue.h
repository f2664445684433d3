// A queue of versions from a writer that must not wait to a thread that may wait.
#pragma once

#include <cstddef>
#include <cstdint>
#include <deque>

#include "robot/core/lock.h"
#include "robot/memory/channel.h"

namespace robot::logging {

/// How long versions may collect before they are due.
struct Patience {
  std::uint64_t time_ns = 0;
  std::size_t bytes = 0;  // this many queued bytes are due earlier
};

/// A queue bounded in bytes. When it is full, it drops and counts the oldest versions to make room for the newest.
/// One version that is larger than the bound still passes, alone.
///
/// The wake-up of a thread is by far the most expensive part of a write, and that thread may displace the writer from
/// its processor. A write therefore wakes no thread: a Bell asks periodically whether versions are due.
class VersionQueue final : public memory::Listener {
 public:
  explicit VersionQueue(std::size_t max_bytes, Patience patience = {}) : max_bytes_(max_bytes), patience_(patience) {}

  /// Appends `version`. Does not wait. Without memory for it, counts it as dropped. Any thread.
  void on_version(const memory::VersionPtr& version) override;

  /// Returns whether a limit of the patience is reached at `now_ns` [monotonic]. The waiting time begins with the first
  /// call that finds versions. Does not wait: returns false while another thread uses the queue. Any thread.
  bool due(std::uint64_t now_ns);

  /// Wakes a waiting pop(). Any thread.
  void wake() { filled_.notify_one(); }

  /// Removes and returns the oldest version. Waits for one until monotonic_ns() reaches `deadline_ns`, then returns
  /// null. Returns null at once when the queue is closed and empty.
  memory::VersionPtr pop(std::uint64_t deadline_ns);

  /// Stops accepting versions and wakes a waiting pop(). Queued versions can still be popped. Any thread.
  void close();

  bool closed() const;

  /// The facts about a queue at one moment.
  struct State {
    std::uint64_t first = 0, last = 0;  // sequence numbers of the first and the last version that arrived; 0: none yet
    std::uint64_t dropped = 0;          // versions since the beginning
    std::size_t waiting = 0;            // queued versions
    std::size_t bytes = 0;              // of the queued versions
  };

  /// Any thread.
  State state() const;

 private:
  const std::size_t max_bytes_;
  const Patience patience_;
  mutable Mutex lock_;
  Condition filled_;
  std::deque<memory::VersionPtr> versions_;
  std::size_t bytes_ = 0;
  std::uint64_t noticed_ns_ = 0;  // when due() first saw the waiting versions; 0: not yet
  std::uint64_t first_ = 0, last_ = 0;
  std::uint64_t dropped_ = 0;
  bool closed_ = false;
};

}  // namespace robot::logging
