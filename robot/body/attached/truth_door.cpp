#include "robot/body/attached/truth_door.h"

#include <utility>

#include "proto/foresight/truth.pb.h"
#include "robot/memory/memory_object.h"

namespace robot::body {
namespace {

/// Lists /truth/world as in the memory of a robot.
Result<void> list_world(memory::Channels& channels, const Clock& clock) {
  if (channels.find(memory::kTruthTopic)) return {};
  const auto world = std::make_shared<memory::MemoryObject<foresight::GroundTruth>>();
  world->announce(memory::kTruthTopic, memory::Delivery::latest, clock);
  return channels.add(world);
}

}  // namespace

Result<std::unique_ptr<Door>> open_truth_door(std::filesystem::path path, const std::set<std::string>& own_objects,
                                              const SessionClock& clock, memory::Channels& channels,
                                              logging::LoggingBoard& board) {
  if (Result<void> listed = list_world(channels, clock); !listed) return listed.failure();
  DoorOptions options{.path = std::move(path), .robot = "truth", .written_below = "/truth/"};
  options.own_objects.insert(own_objects.begin(), own_objects.end());
  return Door::open(std::move(options), clock, channels, board);
}

}  // namespace robot::body
