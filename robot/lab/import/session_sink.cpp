#include "robot/lab/import/session_sink.h"

#include "robot/memory/memory.h"

namespace robot::lab {

SessionSink::SessionSink(std::string_view robot, logging::SessionWriter& writer) : writer_(writer) {
  const ManualClock clock;
  memory::Memory memory(robot, clock);
  memory.visit(
      [this](std::string_view name, const auto& object, memory::Delivery) { channels_.emplace(name, object.info()); });
}

Result<void> SessionSink::message(std::string_view object, std::uint64_t capture_ns,
                                  const google::protobuf::Message& value) {
  const auto channel = channels_.find(object);
  if (channel == channels_.end()) return Error{"import: no memory object is called '" + std::string(object) + "'"};
  value.SerializeToString(&bytes_);
  return writer_.write(channel->second, capture_ns, bytes_);
}

}  // namespace robot::lab
