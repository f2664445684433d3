#include "robot/net/foxglove/services.h"

#include <utility>

#include "robot/core/json.h"
#include "robot/core/json_library.h"

namespace robot::net {

using Json = nlohmann::json;

Json failure(std::string_view sentence) { return {{"ok", false}, {"error", sentence}}; }

Json refused(std::string_view sentence, const ClientContext& client) {
  Json answer = failure(sentence);
  answer["cause"] = client.cause();
  return answer;
}

void Services::add(std::string name, For whom, Handler handler) {
  services_.push_back({std::move(name), whom, std::move(handler)});
}

std::string ClientContext::refusal() const {
  if (!may_control) return "control from another machine needs the control token: add ?token=<token> to the address";
  return match_mode && !loopback
             ? "a game is in progress: control is for this machine alone until it has finished; in a "
               "test game --practice allows it"
             : "";
}

std::vector<foxglove::Service> Services::list() const {
  std::vector<foxglove::Service> list;
  for (const Entry& entry : services_) list.push_back({static_cast<std::uint32_t>(list.size() + 1), entry.name});
  return list;
}

std::string Services::refusal(std::uint32_t id, const ClientContext& client) const {
  const Entry& entry = services_.at(id - 1);
  if (entry.whom == For::everybody || (entry.whom == For::questions && client.may_control)) return "";
  const std::string why = client.refusal();
  return why.empty() ? "" : entry.name + ": " + why;
}

std::string Services::call(std::uint32_t id, std::string_view request, const ClientContext& client) const {
  const std::string why = refusal(id, client);
  const Json said = why.empty() ? answer(services_.at(id - 1), request, client) : refused(why, client);
  return said.dump(-1, ' ', false, Json::error_handler_t::replace);
}

Json Services::answer(const Entry& entry, std::string_view request, const ClientContext& client) const {
  const Result<Json> json = request.empty() ? Json::object() : parse_json(request);
  if (!json) return failure(entry.name + ": " + json.error());
  if (!json->is_object()) return failure(entry.name + ": expected a JSON object, got something else");
  try {
    return entry.handler(*json, client);
  } catch (const Json::exception& exception) {
    // a field of another type than the handler expected
    return failure(entry.name + ": " + exception.what());
  }
}

void add_clock_sync(Services& services, const Clock& clock, std::function<void(const PeerClock&)> on_measured) {
  services.add(
      "clock_sync", Services::For::everybody,
      [&clock, on_measured = std::move(on_measured)](const Json& request, const ClientContext& client) -> Json {
        const std::uint64_t received_ns = clock.now_ns();
        if (!number_in_text<std::uint64_t>(request, "sent_ns"))
          return failure("clock_sync: 'sent_ns' must be a text with a whole number");
        if (const auto offset = number_in_text<std::int64_t>(request, "offset_ns"); offset && on_measured)
          on_measured({client.address, *offset, number_in_text<std::uint64_t>(request, "round_trip_ns")});
        return {{"ok", true}, {"sent_ns", request["sent_ns"]}, {"received_ns", std::to_string(received_ns)}};
      });
}

}  // namespace robot::net
