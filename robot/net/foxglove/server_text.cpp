// The text messages of a server, read by our client.
#include <limits>
#include <utility>

#include "robot/core/encoding.h"
#include "robot/core/json.h"
#include "robot/core/json_library.h"
#include "robot/net/foxglove/to_client.h"

namespace robot::net::foxglove {
namespace {

using Json = nlohmann::json;

/// Replaces the spellings of not-a-number and infinity, which many libraries write and JSON does not have, by null.
std::string with_null_for_nan(std::string_view text) {
  constexpr std::string_view kSpellings[] = {"-Infinity", "Infinity", "-NaN", "NaN", "-nan", "nan", "-inf", "inf"};
  std::string json;
  bool in_text = false;
  while (!text.empty()) {
    std::size_t taken = in_text && text.size() > 1 && text[0] == '\\' ? 2 : 1;
    if (text[0] == '"') in_text = !in_text;
    std::string_view put = text.substr(0, taken);
    for (const std::string_view spelling : kSpellings)
      if (!in_text && text.starts_with(spelling)) put = "null", taken = spelling.size();
    json += put;
    text.remove_prefix(taken);
  }
  return json;
}

Result<Json> parse_leniently(std::string_view text) {
  Result<Json> json = parse_json(text);
  return json ? std::move(json) : parse_json(with_null_for_nan(text));
}

memory::Delivery delivery_of(const std::map<std::string, std::string>& metadata) {
  const auto found = metadata.find("delivery");
  if (found == metadata.end()) return memory::Delivery::fifo;  // another server: its delivery is unknown
  for (const auto delivery : {memory::Delivery::latest, memory::Delivery::reliable})
    if (found->second == memory::name(delivery)) return delivery;
  return memory::Delivery::fifo;
}

std::string text_of(const Json& object, const char* key) {
  const auto found = object.find(key);
  return found != object.end() && found->is_string() ? found->get<std::string>() : std::string();
}

std::map<std::string, std::string> texts_of(const Json& object, const char* key) {
  std::map<std::string, std::string> texts;
  const auto inner = object.find(key);
  if (inner == object.end() || !inner->is_object()) return texts;
  for (const auto& [name, value] : inner->items())
    if (value.is_string()) texts[name] = value.get<std::string>();
  return texts;
}

std::optional<std::uint32_t> id_at(const Json& object, const char* key) {
  const std::optional<std::int64_t> id = whole_number(object.value(key, Json()));
  if (!id || *id < 0 || *id > std::numeric_limits<std::uint32_t>::max()) return std::nullopt;
  return static_cast<std::uint32_t>(*id);
}

/// Returns the id of an element of a list. `name` is the member that names the element.
Result<std::uint32_t> id_of(const Json& element, const char* name) {
  if (!element.is_object()) return Error{"expected an object, got " + shown(element)};
  if (const auto id = id_at(element, "id")) return *id;
  return Error{"expected a whole number 0 .. 4294967295 as 'id' of " + shown(element.value(name, Json())) + ", got " +
               shown(element.value("id", Json()))};
}

Result<Advertised> parse_channel(const Json& json) {
  const Result<std::uint32_t> id = id_of(json, "topic");
  if (!id) return id.failure();
  Advertised channel{.id = *id};
  channel.info.topic = text_of(json, "topic");
  if (channel.info.topic.empty())
    return Error{"expected a text as 'topic' of channel " + std::to_string(*id) + ", got " +
                 shown(json.value("topic", Json()))};
  channel.info.message_encoding = text_of(json, "encoding");
  channel.info.schema.name = text_of(json, "schemaName");
  channel.info.schema.encoding = text_of(json, "schemaEncoding");
  channel.info.schema.bytes = text_of(json, "schema");
  if (channel.info.schema.encoding == "protobuf") {
    auto bytes = from_base64(channel.info.schema.bytes);
    if (!bytes) return bytes.failure("the schema of " + shown(channel.info.topic));
    channel.info.schema.bytes = std::move(*bytes);
  }
  channel.metadata = texts_of(json, "metadata");
  channel.info.delivery = delivery_of(channel.metadata);
  return channel;
}

Result<Service> parse_service(const Json& json) {
  const Result<std::uint32_t> id = id_of(json, "name");
  if (!id) return id.failure();
  return Service{*id, text_of(json, "name")};
}

ServerInfo parse_info(const Json& message) {
  ServerInfo info{.name = text_of(message, "name"),
                  .capabilities = {},
                  .encodings = {},
                  .metadata = texts_of(message, "metadata"),
                  .session_id = text_of(message, "sessionId")};
  if (const auto capabilities = message.find("capabilities"); capabilities != message.end())
    for (const Json& capability : *capabilities)
      if (capability.is_string()) info.capabilities.push_back(capability.get<std::string>());
  return info;
}

/// Adds the elements of the list `key` to `items`, and a sentence to `problems` for each that is wrong.
template <class Item>
void read_list(const Json& message, const std::string& op, const char* key, Result<Item> (*parse)(const Json&),
               std::vector<Item>& items, std::vector<std::string>& problems) {
  const auto list = message.find(key);
  if (list == message.end() || !list->is_array()) {
    problems.push_back(op + ": expected an array as '" + key + "', got " + shown(message.value(key, Json())));
    return;
  }
  for (const Json& json : *list) {
    Result<Item> item = parse(json);
    if (item)
      items.push_back(std::move(*item));
    else
      problems.push_back(op + ": " + item.error());
  }
}

}  // namespace

Result<ServerText> parse_server_text(std::string_view text) {
  const Result<Json> parsed = parse_leniently(text);
  if (!parsed) return parsed.failure("server message");
  const Json& message = *parsed;
  if (!message.is_object() || text_of(message, "op").empty())
    return Error{"server message: expected a JSON object with 'op', got " + shown(message)};
  const std::string op = text_of(message, "op");
  ServerText read;
  if (op == "serverInfo") read.info = parse_info(message);
  if (op == "advertise") read_list(message, op, "channels", parse_channel, read.channels, read.problems);
  if (op == "advertiseServices") read_list(message, op, "services", parse_service, read.services, read.problems);
  if (op == "serviceCallFailure") {
    const auto service = id_at(message, "serviceId"), call = id_at(message, "callId");
    if (service && call)
      read.failed_call = {.service = *service, .call = *call, .message = text_of(message, "message")};
  }
  return read;
}

Result<std::vector<Advertised>> parse_advertise(std::string_view text) {
  auto read = parse_server_text(text);
  if (!read) return read.failure();
  return std::move(read->channels);
}

}  // namespace robot::net::foxglove
