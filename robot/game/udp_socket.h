// A UDP socket, with a way to wake the thread that waits for it.
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

/// The source or destination of a packet: IPv4 only, as for the GameController.
struct Endpoint {
  std::uint32_t address = 0;  // host byte order
  std::uint16_t port = 0;

  bool operator==(const Endpoint&) const = default;
};

/// Returns the endpoint as text, such as "192.168.14.2:3838".
std::string text_of(const Endpoint& endpoint);

/// Parses an IPv4 address such as "192.168.14.2" (host byte order); returns an Error for any other text.
Result<std::uint32_t> parse_address(std::string_view text);

/// Returns true if `address` (host byte order) is one of this machine's addresses now.
bool is_own_address(std::uint32_t address);

/// A received packet.
struct Datagram {
  std::string bytes;
  Endpoint from;
};

/// A UDP socket. One thread calls receive(); any thread may call send() and wake().
class UdpSocket {
 public:
  /// Listens on `port` (0: any) of the given local address (host byte order; 0: all). Another program that allows
  /// sharing may listen on the same port; each gets a copy of every broadcast. The socket may send broadcasts.
  static Result<UdpSocket> open(std::uint32_t address, std::uint16_t port);

  /// Returns the port on which it listens.
  std::uint16_t port() const { return port_; }

  /// Returns the next packet, or nothing after wake() or when monotonic_ns() reaches `deadline_ns`. A packet longer
  /// than 2048 bytes is cut; no packet of a game is that long.
  std::optional<Datagram> receive(std::optional<std::uint64_t> deadline_ns = {});

  /// Ends the current and every later receive().
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
