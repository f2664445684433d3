#include "robot/app/services/parameter_service.h"
#include "robot/core/json_library.h"

#include <memory>
#include <variant>
#include <vector>

namespace robot::app {
namespace {

std::string text_of(const net::Parameters& parameters) {
  auto all = nlohmann::json::object();
  for (const std::string& name : parameters.names())
    if (const auto value = parameters.get(name)) std::visit([&](const auto& content) { all[name] = content; }, *value);
  return all.dump(-1, ' ', false, nlohmann::json::error_handler_t::replace);
}

}  // namespace

Result<void> add_parameter_service(net::Parameters& parameters, const std::string& robot, memory::Channels& channels,
                                   const Clock& clock) {
  const auto object = std::make_shared<memory::RawChannel>(
      memory::ChannelInfo{.topic = "/" + robot + "/parameters", .message_encoding = "json"}, clock);
  if (Result<void> added = channels.add(object); !added) return added;
  const auto write = [&parameters, &clock, object] {
    [[maybe_unused]] const Result<void> written = object->write_bytes(text_of(parameters), clock.now_ns());
  };
  write();
  parameters.listen([write](const std::vector<std::string>&) { write(); });
  return {};
}

}  // namespace robot::app
