// Messages from a Foxglove client to a server (Foxglove WebSocket protocol v1): pure parsers and writers.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "robot/core/result.h"
#include "robot/net/foxglove/parameters.h"

namespace robot::net::foxglove {

struct Subscribe {
  struct Item {
    std::uint32_t subscription, channel;
  };
  std::vector<Item> subscriptions;
};

struct Unsubscribe {
  std::vector<std::uint32_t> subscriptions;
};

struct GetParameters {
  std::vector<std::string> names;  // empty: all
  std::optional<std::string> id;   // repeated in the answer
};

struct SetParameters {
  struct Item {
    std::string name;
    std::optional<ParameterValue> value;  // nothing: the client wants it unset, or sent a type that no parameter has
  };
  std::vector<Item> parameters;
  std::optional<std::string> id;
};

/// Parameters whose changes the client wants to receive from now on, or no longer.
struct WatchParameters {
  bool watch = true;
  std::vector<std::string> names;  // empty: all
};

struct ServiceCall {
  std::uint32_t service = 0, call = 0;
  std::string encoding, payload;
};

/// A message for a channel that the client advertised. Our servers refuse it.
struct ClientPublish {
  std::uint32_t channel = 0;
  std::string payload;
};

struct PlaybackControl {
  bool play = false;
  float speed = 1;
  std::optional<std::uint64_t> seek_ns;
  std::string request_id;
};

/// An extension of the protocol, for clients that watch a recording: a playhead of one's own, or the shared playback. A
/// playhead of one's own goes on where the shared one is. The answer is the server's message of the same op.
struct ChoosePlayhead {
  bool own = false;
};

/// A request of the protocol that needs a capability we do not announce.
struct Unsupported {
  std::string op;
};

using ClientMessage = std::variant<Subscribe, Unsubscribe, GetParameters, SetParameters, WatchParameters, ServiceCall,
                                   ClientPublish, PlaybackControl, ChoosePlayhead, Unsupported>;

/// Reads a text message. Returns an Error that says why it is wrong.
Result<ClientMessage> parse_client_text(std::string_view text);

/// Reads a binary message. Returns an Error that says why it is wrong.
Result<ClientMessage> parse_client_binary(std::string_view bytes);

/// Returns the text of a client's `subscribe`.
std::string to_text(const Subscribe& subscribe);

/// Returns the text of a client's `unsubscribe`.
std::string to_text(const Unsubscribe& unsubscribe);

/// Returns the bytes of a client's binary messages.
std::string to_bytes(const ServiceCall& call);
std::string to_bytes(const ClientPublish& message);
std::string to_bytes(const PlaybackControl& control);

}  // namespace robot::net::foxglove
