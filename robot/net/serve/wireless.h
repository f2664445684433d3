// Silence on wireless networks during a game, as the league's rules demand.
#pragma once

#include <string>
#include <vector>

#include "robot/core/result.h"

namespace robot::net {

/// Some network interfaces of this machine, as they are now.
class Wireless {
 public:
  /// No interfaces.
  Wireless() = default;

  /// The interfaces called `names`; names that do not exist are ignored. If `names` is empty: all interfaces except
  /// those that are surely loopback or a cable. A bridge, a tunnel, a phone and any other unknown kind is taken for
  /// wireless.
  explicit Wireless(const std::vector<std::string>& names);

  /// Makes the kernel drop all packets from these interfaces to the listening `socket`, without an answer.
  /// Without interfaces the socket accepts everything again.
  Result<void> silence(int socket) const;

  /// Returns whether the local address of the connection `socket` belongs to one of these interfaces.
  bool carries(int socket) const;

 private:
  std::vector<unsigned> indices_;
  std::vector<std::string> addresses_;  // bytes as in the packets
};

}  // namespace robot::net
