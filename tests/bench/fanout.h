// Two servers that send the same messages to the same clients as fast as they can: how much processor time does a
// message cost?
#pragma once

#include <atomic>
#include <cstdint>

namespace bench {

inline constexpr std::size_t kMaxFanoutClients = 16;

/// Shared memory of the server and its clients, two processes.
struct FanoutShared {
  std::atomic<std::uint16_t> port = 0;  // 0: the server is not ready yet
  std::atomic<bool> ended = false;
  std::atomic<std::uint64_t> making_ns = 0;                     // CPU time of making the messages, which is subtracted
  std::atomic<std::uint64_t> received[kMaxFanoutClients] = {};  // [messages]

  /// Count of the slowest of `clients`, or of all together.
  std::uint64_t least(std::size_t clients) const {
    std::uint64_t least = UINT64_MAX;
    for (std::size_t i = 0; i < clients; ++i) least = received[i] < least ? received[i].load() : least;
    return least;
  }
  std::uint64_t total(std::size_t clients) const {
    std::uint64_t total = 0;
    for (std::size_t i = 0; i < clients; ++i) total += received[i];
    return total;
  }
};

struct FanoutLoad {
  std::size_t payload_bytes = 64;
  std::size_t clients = 1;
};

/// Both serve until `shared.ended`: they set `shared.port` when clients may connect, and begin with the first client.

/// net::Server, with a producer that hands versions to it as fast as it takes them.
void serve_ours(const FanoutLoad& load, FanoutShared& shared);

/// The plain way: a Beast WebSocket stream per client, one async_write per message.
void serve_beast(const FanoutLoad& load, FanoutShared& shared);

}  // namespace bench
