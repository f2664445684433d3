#include "robot/memory/memory.h"

namespace robot::memory {

Memory::Memory(std::string_view robot, const Clock& time) {
  visit([&](std::string_view name, auto& object, Delivery delivery) {
    const bool own_topic = name.starts_with('/');
    object.announce(own_topic ? std::string(name) : "/" + std::string(robot) + "/" + std::string(name), delivery, time);
  });
}

Memory::~Memory() = default;

Result<void> list(const std::shared_ptr<Memory>& memory, Channels& channels) {
  Result<void> listed;
  memory->visit([&](std::string_view, auto& object, Delivery) {
    if (listed) listed = channels.add(std::shared_ptr<Channel>(memory, &object));
  });
  return listed;
}

}  // namespace robot::memory
