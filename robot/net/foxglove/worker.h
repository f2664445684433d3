// A thread that runs tasks for callers that must not wait.
#pragma once

#include <deque>
#include <functional>
#include <string>
#include <thread>
#include <utility>

#include "robot/core/lock.h"
#include "robot/core/result.h"

namespace robot::net {

/// A thread that runs its tasks one after the other, in the order of post().
class Worker {
 public:
  /// `name` is that of the thread.
  explicit Worker(std::string name) : name_(std::move(name)) {}

  /// As finish().
  ~Worker() { finish(); }

  /// Starts the thread; posted tasks wait until then. Returns an Error if the system allows no more threads.
  Result<void> start();

  /// Appends `task`. After finish() it has no effect. Any thread.
  void post(std::function<void()> task);

  /// Removes the tasks that have not begun. Any thread.
  void forget();

  /// Runs the remaining tasks and ends the thread. A worker that was never started forgets its tasks.
  void finish();

 private:
  void run();

  const std::string name_;
  Mutex lock_;
  Condition changed_;
  std::deque<std::function<void()>> tasks_;
  bool finishing_ = false;
  std::thread thread_;  // declared last, because it uses all other members
};

}  // namespace robot::net
