// The WebSocket handshake (RFC 6455, section 4) of client and server, as pure functions.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "robot/core/result.h"
#include "robot/net/http/http.h"

namespace robot::net {

/// The subprotocols of the Foxglove protocol v1, the preferred one first; the bytes are the same.
inline constexpr std::string_view kSubprotocols[] = {"foxglove.sdk.v1", "foxglove.websocket.v1"};

/// Returns whether `request` asks for a WebSocket.
bool wants_web_socket(const HttpRequest& request);

/// An agreed handshake.
struct Upgrade {
  std::string subprotocol;
  std::string response;  // status line and headers, sent unchanged
};

/// Accepts `request`, or returns an Error with the reason for refusing it (400).
Result<Upgrade> accept_web_socket(const HttpRequest& request);

/// For clients: returns the request for `target` at `host`, both as in the header. `key` is base64 of 16 random bytes.
std::string web_socket_request(std::string_view host, std::string_view target, std::string_view key);

/// For clients: checks the head of the response, up to the empty line.
Result<void> check_web_socket_response(std::string_view head, std::string_view key);

}  // namespace robot::net
