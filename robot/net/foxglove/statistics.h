// Statistics of the server's clients, for the memory object `runtime` and for /api/status.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace robot::net {

struct ClientChannelStatistics {
  std::string topic;
  std::uint64_t sent = 0;     // [messages] handed to the socket
  std::uint64_t dropped = 0;  // [messages] dropped for newer ones, or lost before they reached the queue
  std::size_t queued_messages = 0, queued_bytes = 0;
};

struct ClientStatistics {
  std::uint64_t id = 0;    // counts up; never used twice in one run
  std::string address;     // host:port
  std::string user_agent;  // the client's own text; may be empty
  std::string subprotocol;
  std::optional<std::uint64_t> round_trip_ns;  // by WebSocket ping; absent until the first answer
  bool lossless = false;
  std::vector<ClientChannelStatistics> channels;  // every channel it ever watched
};

struct ServerStatistics {
  std::vector<ClientStatistics> clients;
};

}  // namespace robot::net
