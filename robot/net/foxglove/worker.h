// A thread that runs tasks for callers that must not wait.
#pragma once

#include <deque>
#include <functional>
#include <string>
#include <thread>

#include "robot/core/lock.h"

namespace robot::net {

/// A thread that runs its tasks one after the other, in the order of post().
class Worker {
 public:
  explicit Worker(std::string name);

  /// As finish().
  ~Worker() { finish(); }

  /// Appends `task`. After finish() it has no effect. Any thread.
  void post(std::function<void()> task);

  /// Removes the tasks that have not begun. Any thread.
  void forget();

  /// Runs the remaining tasks and ends the thread.
  void finish();

 private:
  void run();

  Mutex lock_;
  Condition changed_;
  std::deque<std::function<void()>> tasks_;
  bool finishing_ = false;
  std::thread thread_;  // declared last, because it uses all other members
};

}  // namespace robot::net
