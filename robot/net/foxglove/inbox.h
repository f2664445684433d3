// The queue into the server's I/O thread.
#pragma once

#include <cstdint>
#include <functional>
#include <vector>

#include "robot/core/lock.h"
#include "robot/memory/channel.h"

namespace robot::net {

/// A queue of messages from loggers and of tasks from any thread. It wakes the I/O thread once for all items until the
/// next take(). It is bounded in bytes: a logger waits while it is full, and the logger's own queue drops and counts.
/// Any thread.
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

  /// `wake` is called for the first item after a take(), under a lock. It must return at once.
  Inbox(std::size_t max_bytes, std::function<void()> wake) : max_bytes_(max_bytes), wake_(std::move(wake)) {}

  /// Appends `item`; waits while the inbox is full. Returns false, without the item, if `cancelled` was set by cancel()
  /// or the inbox is closed.
  bool put(Item item, const bool& cancelled);

  /// Sets `cancelled`, which belongs to one producer, and ends its wait.
  void cancel(bool& cancelled);

  /// Appends `task` for the I/O thread. Does not wait. A closed inbox ignores it.
  void post(Task task);

  /// Empties `contents`, then swaps it with the queued items and tasks.
  void take(Contents& contents);

  /// Refuses further items, ends all waits, and calls `wake` no more.
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
