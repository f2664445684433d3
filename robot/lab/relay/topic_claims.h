// The choice of the robot that carries a topic, if several robots offer it.
#pragma once

#include <map>
#include <string>

#include "robot/core/lock.h"

namespace robot::lab {

/// The table of topics and the links that carry them. A topic with a robot's name is carried by that robot once it is
/// known. Any other topic, such as the truth of a game that several simulate, is carried by the first link that offers
/// it. Used by any thread.
class TopicClaims {
 public:
  /// Registers the link `owner` as the robot `robot` ("14/2"), which then owns the topics of that name. Returns false
  /// if another link is that robot already.
  bool introduce(const std::string& robot, int owner);

  /// Offers `topic` by `owner`. Returns whether `owner` carries it.
  bool claim(const std::string& topic, int owner);

  /// Returns whether `owner` still carries `topic`.
  bool holds(const std::string& topic, int owner) const;

 private:
  mutable Mutex lock_;
  std::map<std::string, int> robots_, topics_;  // to their owners
};

}  // namespace robot::lab
