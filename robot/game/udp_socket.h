// One UDP socket, and a way to wake the thread that waits for it.
#pragma once

#include <netinet/in.h>

#include <atomic>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <string_view>

#include "robot/core/files.h"
#include "robot/core/result.h"

namespace robot::game {

/// Where a packet came from or goes to: IPv4 only, as the GameController.
struct Endpoint {
  std::uint32_t address = 0;  // host byte order
  std::uint16_t port = 0;

  bool operator==(const Endpoint&) const = default;
};

/// "192.168.14.2:3838"
std::string text_of(const Endpoint& endpoint);

/// Reads "192.168.14.2"; an Error for anything else.
Result<std::uint32_t> parse_address(std::string_view text);

/// Whether `address` (host byte order) is one of this machine's now.
bool is_own_address(std::uint32_t address);

struct Datagram {
  std::string bytes;
  Endpoint from;
};

/// receive() belongs to one thread; send() and wake() to any.
class UdpSocket {
 public:
  /// Listens on `port` of the given local address (host byte order; 0: all), 0 chooses a port. Other programs may listen
  /// on the same port, if they allow it, too: each gets a copy of what is broadcast. May send to everybody.
  static Result<UdpSocket> open(std::uint32_t address, std::uint16_t port);

  /// The port it listens on.
  std::uint16_t port() const { return port_; }

  /// The next packet; nothing after wake(), or when `deadline_ns` of monotonic_ns() has passed. What is longer than
  /// 2048 bytes is cut there: no packet of a game is.
  std::optional<Datagram> receive(std::optional<std::uint64_t> deadline_ns = {});

  /// Ends this and every later receive().
  void wake();
  bool woken() const { return *woken_; }

  Result<void> send(const Endpoint& to, std::string_view bytes);

 private:
  UdpSocket() = default;

  FileDescriptor socket_, wake_;
  std::unique_ptr<std::atomic<bool>> woken_ = std::make_unique<std::atomic<bool>>(false);
  std::uint16_t port_ = 0;
};

}  // namespace robot::game
