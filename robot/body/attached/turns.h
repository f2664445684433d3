// Turns of the processes that write the same object.
#pragma once

#include <atomic>
#include <set>
#include <string>

#include "robot/core/lock.h"

namespace robot::body {

/// The objects that have a writer now; each has at most one. If a process is killed and restarts at once, its earlier
/// messages still arrive before its new ones. Two frameworks that run by mistake never mix their images. Any thread.
class Turns {
 public:
  /// Waits until `topic` has no writer, and takes the turn. Returns false if `given_up` becomes true. After a second it
  /// reports that `who` waits.
  bool take(const std::string& topic, const std::string& who, const std::atomic<bool>& given_up);

  void give_back(const std::string& topic);

  /// Wakes all waiting threads, so that they check `given_up`.
  void wake();

 private:
  Mutex lock_;
  Condition changed_;
  std::set<std::string> taken_;
};

}  // namespace robot::body
