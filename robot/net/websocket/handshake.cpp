#include "robot/net/websocket/handshake.h"

#include <utility>  // before Asio: Boost 1.74 uses std::exchange without it

#define BOOST_ERROR_CODE_HEADER_ONLY
#include <boost/beast/http/fields.hpp>
#include <boost/beast/http/message.hpp>
#include <boost/beast/websocket/rfc6455.hpp>
#include <optional>

#include "robot/core/encoding.h"
#include "robot/net/http/response_head.h"

namespace robot::net {
namespace {

namespace http = boost::beast::http;

// several lines of one header count as one line, as RFC 9110 says
http::request_header<> to_beast(const HttpRequest& request) {
  http::request_header<> header;
  header.version(11);  // HTTP/1.1
  header.method_string(request.method);
  for (const auto& [name, value] : request.headers) {
    const auto before = header[name];
    header.set(name, before.empty() ? value : std::string(before) + ", " + value);
  }
  return header;
}

// Beast computes this only for a stream that it then sends through
std::string accept_value(std::string_view key) {
  const auto digest = sha1(std::string(key) + "258EAFA5-E914-47DA-95CA-C5AB0DC85B11");
  return to_base64({reinterpret_cast<const char*>(digest.data()), digest.size()});
}

// names of subprotocols have one spelling only (RFC 6455, section 4.1): a browser refuses an answer in another case
std::optional<std::string_view> chosen_subprotocol(const HttpRequest& request) {
  for (const std::string_view known : kSubprotocols)
    if (request.has_exact_token("sec-websocket-protocol", known)) return known;
  return std::nullopt;
}

}  // namespace

bool wants_web_socket(const HttpRequest& request) { return request.has_token("upgrade", "websocket"); }

Result<Upgrade> accept_web_socket(const HttpRequest& request) {
  const http::request_header<> header = to_beast(request);
  if (!boost::beast::websocket::is_upgrade(header))
    return Error{"WebSocket: expected GET with 'Connection: Upgrade', got another request"};
  if (header[http::field::sec_websocket_version] != "13")
    return Error{"WebSocket: expected version 13, got another or none"};
  const std::string key(header[http::field::sec_websocket_key]);
  const auto nonce = from_base64(key);
  if (!nonce || nonce->size() != 16)
    return Error{"WebSocket: expected a key of 16 bytes in base64, got another or none"};
  const auto subprotocol = chosen_subprotocol(request);
  if (!subprotocol)
    return Error{
        "WebSocket: expected the subprotocol foxglove.sdk.v1 or foxglove.websocket.v1 to be offered, it is not"};

  return Upgrade{.subprotocol = std::string(*subprotocol),
                 .response = plain_head(101, {{"Upgrade", "websocket"},
                                              {"Connection", "Upgrade"},
                                              {"Sec-WebSocket-Accept", accept_value(key)},
                                              {"Sec-WebSocket-Protocol", std::string(*subprotocol)}})};
}

}  // namespace robot::net
