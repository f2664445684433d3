// One writer at a time.
#pragma once

#include <atomic>
#include <set>
#include <string>

#include "robot/core/lock.h"

namespace robot::body {

/// Who writes an object now. A process that was killed and is there again at once finds the rest of its own earlier
/// messages before its new ones, and two frameworks by mistake never mix their images. Any thread.
class Turns {
 public:
  /// Waits until nobody has the turn of `topic` and takes it; false when `given_up` instead. After a second it says
  /// whose messages wait.
  bool take(const std::string& topic, const std::string& who, const std::atomic<bool>& given_up);

  void give_back(const std::string& topic);

  /// Lets those who gave up notice it.
  void wake();

 private:
  Mutex lock_;
  Condition changed_;
  std::set<std::string> taken_;
};

}  // namespace robot::body
