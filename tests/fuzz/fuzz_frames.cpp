// Any bytes from a WebSocket peer or an HTTP client: no crash, bounded memory, the same meaning in pieces of any size.
#include <cstdint>
#include <cstdlib>
#include <string>
#include <string_view>

#include "robot/net/http/http_parser.h"
#include "robot/net/websocket/frames.h"
#include "robot/net/websocket/handshake.h"

namespace {

constexpr std::size_t kCap = 4096;

std::string events(robot::net::Sender sender, std::string_view bytes, std::size_t portion) {
  robot::net::FrameParser parser(sender, kCap);
  std::string log;
  const auto sink = [&](robot::net::Opcode opcode, const std::string& payload) {
    if (payload.size() > kCap) std::abort();
    log += std::to_string(static_cast<int>(opcode)) + ":" + payload + ";";
    return true;
  };
  while (!bytes.empty()) {
    const std::string_view now = bytes.substr(0, portion);
    bytes.remove_prefix(now.size());
    if (const auto violation = parser.feed(now, sink)) log += "!" + std::to_string(violation->close_code);
  }
  return log;
}

void parse_requests(std::string_view bytes, std::size_t portion) {
  robot::net::HttpParser parser;
  while (!bytes.empty()) {
    const std::string_view now = bytes.substr(0, portion);
    bytes.remove_prefix(now.size());
    parser.add(now);
    while (true) {
      const auto request = parser.next();
      if (!request) return;
      if (!*request) break;
      if (const auto target = robot::net::parse_target((*request)->target))
        if (target->path.find("..") != std::string::npos && target->path.find("/../") != std::string::npos)
          std::abort();
      robot::net::accept_web_socket(**request).operator bool();
      robot::net::parse_range((*request)->header("range").value_or(""), 1000);
    }
  }
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  if (size == 0) return 0;
  const std::string_view bytes(reinterpret_cast<const char*>(data) + 1, size - 1);
  const std::size_t portion = data[0] % 16 + 1;
  for (const auto sender : {robot::net::Sender::client, robot::net::Sender::server})
    if (events(sender, bytes, portion) != events(sender, bytes, SIZE_MAX)) std::abort();
  parse_requests(bytes, portion);
  return 0;
}
