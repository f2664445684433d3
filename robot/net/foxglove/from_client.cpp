#include "robot/net/foxglove/from_client.h"

#include <limits>
#include <utility>

#include "robot/core/json.h"
#include "robot/core/json_library.h"
#include "robot/core/little_endian.h"

namespace robot::net::foxglove {
namespace {

using Json = nlohmann::json;

Error wrong(const std::string& what) { return Error{"request: " + what}; }

std::optional<std::uint32_t> as_id(const Json& json) {
  const std::optional<std::int64_t> id = whole_number(json);
  if (!id || *id < 0 || *id > std::numeric_limits<std::uint32_t>::max()) return std::nullopt;
  return static_cast<std::uint32_t>(*id);
}

/// Returns the array `key` of `message`. `read` converts each element to an optional.
template <class Read>
auto list(const Json& message, const char* key, const std::string& expected, Read read)
    -> Result<std::vector<typename decltype(read(message))::value_type>> {
  const auto array = message.find(key);
  if (array == message.end() || !array->is_array())
    return wrong("'" + std::string(key) + "' must be an array of " + expected);
  std::vector<typename decltype(read(message))::value_type> items;
  items.reserve(array->size());
  for (const Json& element : *array) {
    auto item = read(element);
    if (!item) return wrong("'" + std::string(key) + "' must be an array of " + expected);
    items.push_back(*std::move(item));
  }
  return items;
}

std::optional<std::string> as_text(const Json& json) {
  if (!json.is_string()) return std::nullopt;
  return json.get<std::string>();
}

std::optional<Subscribe::Item> as_subscription(const Json& json) {
  if (!json.is_object()) return std::nullopt;
  const auto id = as_id(json.value("id", Json()));
  const auto channel = as_id(json.value("channelId", Json()));
  if (!id || !channel) return std::nullopt;
  return Subscribe::Item{*id, *channel};
}

std::optional<ParameterValue> as_value(const Json& json) {
  if (json.is_boolean()) return json.get<bool>();
  if (json.is_number_unsigned() && json.get<std::uint64_t>() > static_cast<std::uint64_t>(INT64_MAX))
    return json.get<double>();
  if (json.is_number_integer()) return json.get<std::int64_t>();
  if (json.is_number_float()) return json.get<double>();
  if (json.is_string()) return json.get<std::string>();
  return std::nullopt;
}

std::optional<SetParameters::Item> as_parameter(const Json& json) {
  if (!json.is_object()) return std::nullopt;
  auto name = as_text(json.value("name", Json()));
  if (!name) return std::nullopt;
  return SetParameters::Item{*std::move(name), as_value(json.value("value", Json()))};
}

std::optional<std::string> request_id(const Json& message) { return as_text(message.value("id", Json())); }

Result<ClientMessage> parse_op(const std::string& op, const Json& message) {
  if (op == "subscribe") {
    auto items = list(message, "subscriptions", "{id, channelId}, both numbers 0 .. 4294967295", as_subscription);
    if (!items) return items.failure();
    return ClientMessage(Subscribe{std::move(*items)});
  }
  if (op == "unsubscribe") {
    auto ids = list(message, "subscriptionIds", "numbers 0 .. 4294967295", as_id);
    if (!ids) return ids.failure();
    return ClientMessage(Unsubscribe{std::move(*ids)});
  }
  if (op == "setParameters") {
    auto items = list(message, "parameters", "{name, value}", as_parameter);
    if (!items) return items.failure();
    return ClientMessage(SetParameters{std::move(*items), request_id(message)});
  }
  if (op == "getParameters" || op == "subscribeParameterUpdates" || op == "unsubscribeParameterUpdates") {
    auto names = list(message, "parameterNames", "texts", as_text);
    if (!names) return names.failure();
    if (op == "getParameters") return ClientMessage(GetParameters{std::move(*names), request_id(message)});
    return ClientMessage(WatchParameters{op.starts_with('s'), std::move(*names)});
  }
  if (op == "playhead") {
    const Json own = message.value("own", Json());
    if (!own.is_boolean()) return wrong("'own' must be true or false");
    return ClientMessage(ChoosePlayhead{own.get<bool>()});
  }
  for (const char* known :
       {"advertise", "unadvertise", "subscribeConnectionGraph", "unsubscribeConnectionGraph", "fetchAsset"})
    if (op == known) return ClientMessage(Unsupported{op});
  return wrong("the op '" + op.substr(0, 100) + "' is not known");
}

}  // namespace

Result<ClientMessage> parse_client_text(std::string_view text) {
  const Result<Json> message = parse_json(text);
  if (!message) return wrong(message.error());
  if (!message->is_object()) return wrong("expected a JSON object with 'op', got something else");
  const auto op = as_text(message->value("op", Json()));
  if (!op) return wrong("expected a JSON object with 'op', got one without");
  return parse_op(*op, *message);
}

Result<ClientMessage> parse_client_binary(std::string_view bytes) {
  ByteReader reader(bytes);
  const auto opcode = reader.number<std::uint8_t>();
  const auto cut_short = [&] {
    return wrong("a binary message with opcode " + std::to_string(opcode) + " is cut short at " +
                 std::to_string(bytes.size()) + " bytes");
  };
  if (!reader.ok()) return wrong("a binary message is empty");
  if (opcode == 1) {
    ClientPublish message{.channel = reader.number<std::uint32_t>()};
    if (!reader.ok()) return cut_short();
    message.payload = reader.rest();
    return ClientMessage(std::move(message));
  }
  if (opcode == 2) {
    ServiceCall call;
    call.service = reader.number<std::uint32_t>();
    call.call = reader.number<std::uint32_t>();
    call.encoding = reader.text();
    if (!reader.ok()) return cut_short();
    call.payload = reader.rest();
    return ClientMessage(std::move(call));
  }
  if (opcode == 3) {
    PlaybackControl control{.play = reader.number<std::uint8_t>() == 0};
    control.speed = reader.number<float>();
    const bool seek = reader.number<std::uint8_t>() != 0;
    const auto time = reader.number<std::uint64_t>();
    if (seek) control.seek_ns = time;
    control.request_id = reader.text();
    if (!reader.ok()) return cut_short();
    return ClientMessage(std::move(control));
  }
  return wrong("the binary opcode " + std::to_string(opcode) + " is not known");
}

std::string to_text(const Subscribe& subscribe) {
  Json items = Json::array();
  for (const Subscribe::Item& item : subscribe.subscriptions)
    items.push_back({{"id", item.subscription}, {"channelId", item.channel}});
  return Json{{"op", "subscribe"}, {"subscriptions", std::move(items)}}.dump();
}

std::string to_text(const Unsubscribe& unsubscribe) {
  return Json{{"op", "unsubscribe"}, {"subscriptionIds", unsubscribe.subscriptions}}.dump();
}

std::string to_bytes(const ServiceCall& call) {
  std::string bytes = "\x02";
  put(bytes, call.service);
  put(bytes, call.call);
  put_text(bytes, call.encoding);
  return bytes + call.payload;
}

std::string to_bytes(const ClientPublish& message) {
  std::string bytes = "\x01";
  put(bytes, message.channel);
  return bytes + message.payload;
}

std::string to_bytes(const PlaybackControl& control) {
  std::string bytes = "\x03";
  put(bytes, static_cast<std::uint8_t>(control.play ? 0 : 1));
  put(bytes, control.speed);
  put(bytes, static_cast<std::uint8_t>(control.seek_ns ? 1 : 0));
  put(bytes, control.seek_ns.value_or(0));
  put_text(bytes, control.request_id);
  return bytes;
}

}  // namespace robot::net::foxglove
