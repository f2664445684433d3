#include "robot/net/websocket/handshake.h"

#include <algorithm>
#include <cctype>

#include "robot/core/encoding.h"

namespace robot::net {
namespace {

std::string accept_value(std::string_view key) {
  const auto digest = sha1(std::string(key) + "258EAFA5-E914-47DA-95CA-C5AB0DC85B11");
  return to_base64({reinterpret_cast<const char*>(digest.data()), digest.size()});
}

std::optional<std::string_view> chosen_subprotocol(const HttpRequest& request) {
  for (const std::string_view known : kSubprotocols)
    if (request.has_token("sec-websocket-protocol", known)) return known;
  return std::nullopt;
}

}  // namespace

bool wants_web_socket(const HttpRequest& request) { return request.has_token("upgrade", "websocket"); }

Result<Upgrade> accept_web_socket(const HttpRequest& request) {
  if (request.method != "GET" || !request.has_token("connection", "upgrade"))
    return Error{"WebSocket: expected GET with 'Connection: Upgrade', got another request"};
  if (request.header("sec-websocket-version") != "13")
    return Error{"WebSocket: expected version 13, got another or none"};
  const std::string_view key = request.header("sec-websocket-key").value_or("");
  const auto nonce = from_base64(key);
  if (!nonce || nonce->size() != 16)
    return Error{"WebSocket: expected a key of 16 bytes in base64, got another or none"};
  const auto subprotocol = chosen_subprotocol(request);
  if (!subprotocol)
    return Error{
        "WebSocket: expected the subprotocol foxglove.sdk.v1 or foxglove.websocket.v1 to be offered, it is not"};

  return Upgrade{.subprotocol = std::string(*subprotocol),
                 .response =
                     "HTTP/1.1 101 Switching Protocols\r\n"
                     "Upgrade: websocket\r\n"
                     "Connection: Upgrade\r\n"
                     "Sec-WebSocket-Accept: " +
                     accept_value(key) +
                     "\r\n"
                     "Sec-WebSocket-Protocol: " +
                     std::string(*subprotocol) + "\r\n\r\n"};
}

std::string web_socket_request(std::string_view host, std::string_view target, std::string_view key) {
  std::string request = "GET ";
  request.append(target).append(" HTTP/1.1\r\nHost: ").append(host);
  request.append(
      "\r\nUser-Agent: foresight\r\nUpgrade: websocket\r\nConnection: Upgrade\r\nSec-WebSocket-Version: 13\r\n");
  request.append("Sec-WebSocket-Key: ").append(key);
  request.append("\r\nSec-WebSocket-Protocol: ").append(kSubprotocols[0]).append(", ").append(kSubprotocols[1]);
  return request + "\r\n\r\n";
}

Result<void> check_web_socket_response(std::string_view head, std::string_view key) {
  const std::string_view status_line = head.substr(0, head.find("\r\n"));
  if (!status_line.starts_with("HTTP/1.1 101"))
    return Error{"WebSocket: expected the server to agree (101), got '" + std::string(status_line.substr(0, 100)) +
                 "'"};
  std::string lower(head);
  std::ranges::transform(lower, lower.begin(), [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  constexpr std::string_view kName = "\r\nsec-websocket-accept:";
  const std::size_t at = lower.find(kName);
  if (at != std::string::npos) {
    std::string_view value = head.substr(at + kName.size());
    value = value.substr(0, value.find("\r\n"));
    value.remove_prefix(std::min(value.find_first_not_of(' '), value.size()));
    if (value == accept_value(key)) return {};
  }
  return Error{"WebSocket: the server's answer does not belong to our request"};
}

}  // namespace robot::net
