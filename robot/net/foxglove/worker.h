// A thread that does one thing after the other, for those who must not wait.
#pragma once

#include <deque>
#include <functional>
#include <string>
#include <thread>

#include "robot/core/lock.h"

namespace robot::net {

class Worker {
 public:
  explicit Worker(std::string name);

  /// As finish().
  ~Worker() { finish(); }

  /// Does `task` after all tasks before it. Ignored once finish() was called. Any thread.
  void post(std::function<void()> task);

  /// Forgets what has not begun. Any thread.
  void forget();

  /// Does what is left and ends the thread.
  void finish();

 private:
  void run();

  Mutex lock_;
  Condition changed_;
  std::deque<std::function<void()>> tasks_;
  bool finishing_ = false;
  std::thread thread_;  // last: it uses all the others
};

}  // namespace robot::net
