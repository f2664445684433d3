// Who of several robots tells a topic, where more than one could.
#pragma once

#include <map>
#include <string>

#include "robot/core/lock.h"

namespace robot::lab {

/// Each topic is carried by one robot: what is a robot's own by that robot as soon as it is known, anything else, such as
/// the truth of a game that several simulate, by the first who offers it. Any thread.
class TopicClaims {
 public:
  /// `owner` is the robot `robot`, "14/2": topics of that robot are its own. False if somebody else is that one already.
  bool introduce(const std::string& robot, int owner);

  /// Whether `owner`, who offers `topic`, is to carry it.
  bool claim(const std::string& topic, int owner);

  /// Whether it still is.
  bool holds(const std::string& topic, int owner) const;

 private:
  mutable Mutex lock_;
  std::map<std::string, int> robots_, topics_;  // to their owners
};

}  // namespace robot::lab
