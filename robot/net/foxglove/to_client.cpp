#include "robot/net/foxglove/to_client.h"

#include <utility>

#include "robot/core/clock.h"
#include "robot/core/encoding.h"
#include "robot/core/json_library.h"
#include "robot/core/little_endian.h"

namespace robot::net::foxglove {
namespace {

using Json = nlohmann::json;

constexpr char kMessageData = 1, kServiceResponse = 3, kNumberedData = 0x40;

// texts may come from outside: bytes that are not UTF-8 are replaced, because an exception would leave this folder
std::string dump(const Json& json) { return json.dump(-1, ' ', false, Json::error_handler_t::replace); }

Json to_json(const std::string& name, const ParameterValue& value) {
  Json parameter = {{"name", name}};
  std::visit([&](const auto& content) { parameter["value"] = content; }, value);
  // JSON cannot distinguish 15.0 from 15; the type says that 15.5 is possible
  if (std::holds_alternative<double>(value)) parameter["type"] = "float64";
  return parameter;
}

Json parts_of(std::uint64_t time_ns) { return {{"sec", time_ns / kSecond}, {"nsec", time_ns % kSecond}}; }

}  // namespace

std::string server_info(const ServerInfo& info) {
  Json json = {{"op", "serverInfo"},
               {"name", info.name},
               {"capabilities", info.capabilities},
               {"supportedEncodings", info.encodings},
               {"metadata", info.metadata},
               {"sessionId", info.session_id}};
  if (info.data_span_ns) {
    json["dataStartTime"] = parts_of(info.data_span_ns->first);
    json["dataEndTime"] = parts_of(info.data_span_ns->second);
  }
  return dump(json);
}

std::string advertised_channel(const Advertised& channel) {
  const memory::Schema& schema = channel.info.schema;
  return dump({{"id", channel.id},
               {"topic", channel.info.topic},
               {"encoding", channel.info.message_encoding},
               {"schemaName", schema.name},
               {"schemaEncoding", schema.encoding},
               {"schema", schema.encoding == "protobuf" ? to_base64(schema.bytes) : schema.bytes},
               {"metadata", channel.metadata}});
}

std::string advertise(const std::vector<std::string>& channels) {
  std::string text = R"({"op":"advertise","channels":[)";
  for (std::size_t i = 0; i < channels.size(); ++i) text.append(i == 0 ? "" : ",").append(channels[i]);
  return text + "]}";
}

std::string advertise_services(const std::vector<Service>& services) {
  Json list = Json::array();
  for (const Service& service : services) {
    const auto schema = [&](const std::string& suffix) {
      return Json{{"encoding", "json"},
                  {"schemaName", service.name + suffix},
                  {"schemaEncoding", "jsonschema"},
                  {"schema", R"({"type":"object"})"}};
    };
    list.push_back({{"id", service.id},
                    {"name", service.name},
                    {"type", service.name},
                    {"request", schema("_request")},
                    {"response", schema("_response")}});
  }
  return dump({{"op", "advertiseServices"}, {"services", std::move(list)}});
}

std::string status(StatusLevel level, std::string_view message, std::string_view id, std::string_view cause) {
  Json json = {{"op", "status"}, {"level", static_cast<int>(level)}, {"message", message}};
  if (!id.empty()) json["id"] = id;
  if (!cause.empty()) json["cause"] = cause;
  return dump(json);
}

std::string remove_status(std::string_view id) {
  return dump({{"op", "removeStatus"}, {"statusIds", Json::array({std::string(id)})}});
}

std::string parameter_values(const std::vector<std::pair<std::string, ParameterValue>>& parameters,
                             const std::optional<std::string>& id) {
  Json list = Json::array();
  for (const auto& [name, value] : parameters) list.push_back(to_json(name, value));
  Json json = {{"op", "parameterValues"}, {"parameters", std::move(list)}};
  if (id) json["id"] = *id;
  return dump(json);
}

std::string playhead(bool own) { return dump({{"op", "playhead"}, {"own", own}}); }

std::string service_call_failure(std::uint32_t service, std::uint32_t call, std::string_view message) {
  return dump({{"op", "serviceCallFailure"}, {"serviceId", service}, {"callId", call}, {"message", message}});
}

void append_message_data_header(std::string& out, std::uint32_t subscription, std::uint64_t log_time_ns) {
  out += kMessageData;
  put(out, subscription);
  put(out, log_time_ns);
}

void append_numbered_data_header(std::string& out, std::uint32_t subscription, std::uint64_t log_time_ns,
                                 memory::Published published) {
  out += kNumberedData;
  put(out, subscription);
  put(out, log_time_ns);
  put(out, published.sequence);
  put(out, published.publish_ns);
}

std::string time(std::uint64_t time_ns) {
  std::string bytes = "\x02";
  put(bytes, time_ns);
  return bytes;
}

std::string service_response(std::uint32_t service, std::uint32_t call, std::string_view encoding,
                             std::string_view payload) {
  std::string bytes = "\x03";
  put(bytes, service);
  put(bytes, call);
  put_text(bytes, encoding);
  return bytes.append(payload);
}

std::string asset_response(std::uint32_t request, const Result<std::string>& asset) {
  std::string bytes = "\x04";
  put(bytes, request);
  put(bytes, static_cast<std::uint8_t>(asset ? 0 : 1));
  put_text(bytes, asset ? std::string_view() : asset.error());
  return bytes.append(asset ? std::string_view(*asset) : std::string_view());
}

std::string playback_state(Playback playback, std::uint64_t time_ns, float speed, bool did_seek,
                           std::string_view request_id) {
  std::string bytes = "\x05";
  put(bytes, static_cast<std::uint8_t>(playback));
  put(bytes, time_ns);
  put(bytes, speed);
  put(bytes, static_cast<std::uint8_t>(did_seek ? 1 : 0));
  put_text(bytes, request_id);
  return bytes;
}

Result<std::optional<MessageData>> parse_message_data(std::string_view bytes) {
  ByteReader reader(bytes);
  const auto opcode = reader.number<std::uint8_t>();
  if (opcode != kMessageData && opcode != kNumberedData) return std::optional<MessageData>();
  MessageData message{.subscription = reader.number<std::uint32_t>(), .log_time_ns = reader.number<std::uint64_t>()};
  if (opcode == kNumberedData) {
    const auto sequence = reader.number<std::uint64_t>();
    message.published = {.sequence = sequence, .publish_ns = reader.number<std::uint64_t>()};
  }
  if (!reader.ok())
    return Error{"message data: expected a header of " +
                 std::to_string(opcode == kNumberedData ? kNumberedDataHeaderBytes : kMessageDataHeaderBytes) +
                 " bytes, got " + std::to_string(bytes.size())};
  message.payload = reader.rest();
  return std::optional(message);
}

Result<std::optional<ServiceAnswer>> parse_service_answer(std::string_view bytes) {
  ByteReader reader(bytes);
  if (reader.number<std::uint8_t>() != kServiceResponse) return std::optional<ServiceAnswer>();
  ServiceAnswer answer{
      .service = reader.number<std::uint32_t>(), .call = reader.number<std::uint32_t>(), .payload = {}};
  reader.text();  // the encoding: we ask in JSON
  if (!reader.ok()) return Error{"service response: it is cut short at " + std::to_string(bytes.size()) + " bytes"};
  answer.payload = reader.rest();
  return std::optional(answer);
}

}  // namespace robot::net::foxglove
