// The queue into the server's I/O thread: messages from the logger threads, tasks from any thread.
#pragma once

#include <cstdint>
#include <functional>
#include <vector>

#include "robot/core/lock.h"
#include "robot/memory/channel.h"

namespace robot::net {

/// Takes messages from any thread and wakes the I/O thread once for all that come before it looks. Bounded in bytes:
/// a logger thread waits when it is full, so that the logger's own bounded queue drops and counts. Any thread.
class Inbox {
 public:
  struct Item {
    std::uint32_t channel = 0;
    std::uint64_t stream = 0;
    memory::VersionPtr version;
  };
  using Task = std::function<void()>;

  struct Contents {
    std::vector<Item> items;
    std::vector<Task> tasks;
  };

  /// `wake` is called, under a lock, when something comes into an inbox that was taken last: it must return at once.
  Inbox(std::size_t max_bytes, std::function<void()> wake) : max_bytes_(max_bytes), wake_(std::move(wake)) {}

  /// Puts in `item`; waits while the inbox is full. False, and nothing is put in, when `cancelled` has been set by
  /// cancel() or the inbox is closed.
  bool put(Item item, const bool& cancelled);

  /// Sets `cancelled`, which belongs to one producer, and ends its wait.
  void cancel(bool& cancelled);

  /// Has the I/O thread run `task`; never waits. A closed inbox forgets it.
  void post(Task task);

  /// Swaps what is there with `contents`, which is emptied first.
  void take(Contents& contents);

  /// Nothing gets in any more, nobody waits any more, and `wake` is not called any more.
  void close();

 private:
  void wake_reader();

  const std::size_t max_bytes_;
  Mutex lock_;
  Condition room_;
  std::function<void()> wake_;
  Contents contents_;
  std::size_t bytes_ = 0;
  bool woken_ = false, closed_ = false;
};

}  // namespace robot::net
