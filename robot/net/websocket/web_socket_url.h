// Addresses of WebSocket servers.
#pragma once

#include <string>
#include <string_view>

#include "robot/core/result.h"

namespace robot::net {

/// "ws://10.0.14.2:8765/?delivery=lossless", parsed.
struct WebSocketUrl {
  std::string host;  // without brackets
  std::string port = "80";
  std::string target = "/";  // path and query

  std::string authority() const;  // as in the Host header
};

/// Parses a ws:// address. wss is not supported.
Result<WebSocketUrl> parse_web_socket_url(std::string_view url);

}  // namespace robot::net
