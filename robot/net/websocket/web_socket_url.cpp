#include "robot/net/websocket/web_socket_url.h"

#include <algorithm>

namespace robot::net {

std::string WebSocketUrl::authority() const {
  return (host.find(':') == std::string::npos ? host : "[" + host + "]") + ":" + port;
}

Result<WebSocketUrl> parse_web_socket_url(std::string_view url) {
  constexpr std::string_view kScheme = "ws://";
  const Error wrong{"'" + std::string(url.substr(0, 200)) + "': expected an address such as ws://10.0.14.2:8765"};
  if (!url.starts_with(kScheme) || url.find_first_of(" \r\n\t#") != std::string_view::npos) return wrong;
  url.remove_prefix(kScheme.size());

  const std::size_t end = std::min(url.find_first_of("/?"), url.size());
  std::string_view authority = url.substr(0, end);
  WebSocketUrl result{.target = std::string(url.substr(end))};
  if (!result.target.starts_with('/')) result.target.insert(0, "/");

  const std::size_t host_end = authority.starts_with('[') ? authority.find(']') : 0;
  if (host_end == std::string_view::npos) return wrong;
  const std::size_t colon = authority.find(':', host_end);
  if (colon != std::string_view::npos) {
    result.port = authority.substr(colon + 1);
    authority = authority.substr(0, colon);
  }
  if (authority.starts_with('[')) authority = authority.substr(1, host_end - 1);
  result.host = authority;
  const bool port_ok = !result.port.empty() && result.port.size() <= 5 &&
                       std::ranges::all_of(result.port, [](char c) { return c >= '0' && c <= '9'; });
  if (result.host.empty() || !port_ok) return wrong;
  return result;
}

}  // namespace robot::net
