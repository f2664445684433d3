// Messages from a Foxglove server to its clients (Foxglove WebSocket protocol v1): writers, and parsers for our client.
#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "robot/core/result.h"
#include "robot/memory/channel.h"
#include "robot/net/foxglove/parameters.h"

namespace robot::net::foxglove {

struct ServerInfo {
  std::string name;
  std::vector<std::string> capabilities;
  std::vector<std::string> encodings;  // of service requests
  std::map<std::string, std::string> metadata;
  std::string session_id;  // a new id makes the client forget its data
  std::optional<std::pair<std::uint64_t, std::uint64_t>> data_span_ns = {};  // of a recording: its first and last time
};

/// A channel as it is advertised.
struct Advertised {
  std::uint32_t id = 0;
  memory::ChannelInfo info;
  std::map<std::string, std::string> metadata;
};

struct Service {
  std::uint32_t id = 0;
  std::string name;
};

enum class StatusLevel { info = 0, warning = 1, error = 2 };

// the JSON messages

std::string server_info(const ServerInfo& info);

/// Returns one element of `advertise`, with the schema in base64. It is made once per channel.
std::string advertised_channel(const Advertised& channel);
/// Returns an `advertise` with elements made by advertised_channel().
std::string advertise(const std::vector<std::string>& channels);

/// Returns the announcement of services that take and return JSON.
std::string advertise_services(const std::vector<Service>& services);

/// Returns a status. It replaces an earlier one with the same `id`, if that is not empty. A `cause`, an extension of the
/// protocol, names the reason of a refusal for programs, see ClientContext::cause().
std::string status(StatusLevel level, std::string_view message, std::string_view id = {}, std::string_view cause = {});
/// Returns the message that removes the status `id`.
std::string remove_status(std::string_view id);

std::string parameter_values(const std::vector<std::pair<std::string, ParameterValue>>& parameters,
                             const std::optional<std::string>& id);

/// Returns the message that says whether the client has a playhead of its own in the recording. It extends the protocol,
/// for clients that ask for one.
std::string playhead(bool own);

std::string service_call_failure(std::uint32_t service, std::uint32_t call, std::string_view message);

// the binary messages

inline constexpr std::size_t kMessageDataHeaderBytes = 13;
/// Appends the header of a MessageData; the payload follows.
void append_message_data_header(std::string& out, std::uint32_t subscription, std::uint64_t log_time_ns);

/// Appends the header of a MessageData with the version's number and the time at which it entered memory.
/// This extends the protocol, for clients that ask for `?numbered`. They can count missing messages and record exactly.
inline constexpr std::size_t kNumberedDataHeaderBytes = 29;
void append_numbered_data_header(std::string& out, std::uint32_t subscription, std::uint64_t log_time_ns,
                                 memory::Published published);

std::string time(std::uint64_t time_ns);
std::string service_response(std::uint32_t service, std::uint32_t call, std::string_view encoding,
                             std::string_view payload);
std::string asset_response(std::uint32_t request, const Result<std::string>& asset);

enum class Playback : std::uint8_t { playing = 0, paused = 1, buffering = 2, ended = 3 };
std::string playback_state(Playback playback, std::uint64_t time_ns, float speed, bool did_seek,
                           std::string_view request_id);

// for our client

/// Returns the well-formed channels of an `advertise`, no channels for another message, or an Error
/// if `text` is not of the protocol.
Result<std::vector<Advertised>> parse_advertise(std::string_view text);

/// A call that a server could not answer.
struct FailedCall {
  std::uint32_t service = 0, call = 0;
  std::string message;
};

/// The parts of a server's text message that our client uses.
struct ServerText {
  std::optional<ServerInfo> info;  // without encodings and the span of a recording
  std::vector<Advertised> channels;
  std::vector<Service> services;
  std::optional<FailedCall> failed_call;
  std::vector<std::string> problems;  // one sentence for each channel or service that is wrong and left out
};

/// Reads a text message. All parts are empty for a message of another kind. One wrong channel or service takes no other
/// with it. NaN and Infinity, which JSON does not have, count as null. Returns an Error if it is not of the protocol.
Result<ServerText> parse_server_text(std::string_view text);

struct MessageData {
  std::uint32_t subscription = 0;
  std::uint64_t log_time_ns = 0;
  std::optional<memory::Published> published = {};  // of a numbered message
  std::string_view payload = {};
};

/// Reads a MessageData, numbered or not. Returns nothing for another binary message, or an Error if it is cut short.
Result<std::optional<MessageData>> parse_message_data(std::string_view bytes);

struct ServiceAnswer {
  std::uint32_t service = 0, call = 0;
  std::string_view payload;
};

/// Reads a ServiceCallResponse. Returns nothing for another binary message, or an Error if it is cut short.
Result<std::optional<ServiceAnswer>> parse_service_answer(std::string_view bytes);

}  // namespace robot::net::foxglove
