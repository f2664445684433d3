#include "robot/lab/relay/topic_claims.h"

#include <mutex>

namespace robot::lab {
namespace {

/// Returns "14/2" for "/14/2/ball". For other topics the result is not the name of a robot.
std::string robot_of(const std::string& topic) {
  const std::size_t team_end = topic.find('/', 1);
  const std::size_t end = team_end == topic.npos ? topic.npos : topic.find('/', team_end + 1);
  return end == topic.npos ? std::string() : topic.substr(1, end - 1);
}

}  // namespace

bool TopicClaims::introduce(const std::string& robot, int owner) {
  const std::lock_guard guard(lock_);
  return robot.empty() || robots_.try_emplace(robot, owner).first->second == owner;
}

bool TopicClaims::claim(const std::string& topic, int owner) {
  const std::lock_guard guard(lock_);
  if (const auto robot = robots_.find(robot_of(topic)); robot != robots_.end()) return robot->second == owner;
  return topics_.try_emplace(topic, owner).first->second == owner;
}

bool TopicClaims::holds(const std::string& topic, int owner) const {
  const std::lock_guard guard(lock_);
  if (const auto robot = robots_.find(robot_of(topic)); robot != robots_.end()) return robot->second == owner;
  const auto found = topics_.find(topic);
  return found != topics_.end() && found->second == owner;
}

}  // namespace robot::lab
