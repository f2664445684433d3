// A UDP socket that receives the packets of a multicast group.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>

#include "robot/core/files.h"
#include "robot/core/result.h"

namespace robot::truth {

/// The group, its port, and the network on which this machine listens.
struct MulticastAddress {
  std::string group = "224.5.23.2";  // SSL-Vision's
  std::uint16_t port = 10006;        // 0: any, for tests
  std::string interface = "";        // name, such as "eth0"; empty: all
};

/// A receiver of one group. Other programs of this machine may receive the same group. Used by one thread.
class MulticastSocket {
 public:
  struct Packet {
    std::string bytes;
    std::uint64_t age_ns = 0;  // since the kernel received it
  };

  /// Opens the port and joins the group. Returns an Error for a group that is no IPv4 multicast address, for an unknown
  /// interface, and if the port cannot be opened.
  static Result<MulticastSocket> open(const MulticastAddress& address);

  std::uint16_t port() const { return port_; }

  /// Joins the group again: an interface that was unplugged has forgotten it, and a new one never knew. Returns an Error if
  /// no interface takes part.
  Result<void> join();

  /// Returns the next packet, or nothing when monotonic_ns() reaches `deadline_ns`.
  std::optional<Packet> receive(std::uint64_t deadline_ns);

 private:
  explicit MulticastSocket(MulticastAddress address) : address_(std::move(address)) {}

  MulticastAddress address_;
  FileDescriptor socket_;
  std::uint32_t group_ = 0;  // network byte order
  std::uint16_t port_ = 0;
};

}  // namespace robot::truth
