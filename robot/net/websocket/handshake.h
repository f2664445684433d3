// The WebSocket handshake (RFC 6455, section 4) of the server, as pure functions.
#pragma once

#include <string>
#include <string_view>

#include "robot/core/result.h"
#include "robot/net/http/http.h"

namespace robot::net {

/// The subprotocols of the Foxglove protocol v1, the preferred one first; the bytes are the same.
inline constexpr std::string_view kSubprotocols[] = {"foxglove.sdk.v1", "foxglove.websocket.v1"};

/// Returns whether `request` asks for a WebSocket.
bool wants_web_socket(const HttpRequest& request);

/// An agreed handshake.
struct Upgrade {
  std::string subprotocol;  // as the client offered it
  std::string response;     // status line and headers, sent unchanged
};

/// Accepts `request`, or returns an Error with the reason for refusing it (400).
Result<Upgrade> accept_web_socket(const HttpRequest& request);

}  // namespace robot::net
