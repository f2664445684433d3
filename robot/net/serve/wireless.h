// Silence on wireless networks, as the rules of the league ask for during a game.
#pragma once

#include <string>
#include <vector>

#include "robot/core/result.h"

namespace robot::net {

/// Some network interfaces of this machine, as they are now.
class Wireless {
 public:
  /// None.
  Wireless() = default;

  /// Those called so; all that the system says are wireless if no name is given. Names that do not exist are left out.
  explicit Wireless(const std::vector<std::string>& names);

  /// From now on the kernel drops what `socket`, which listens, receives over these, and answers nothing. With none it
  /// takes everything again.
  Result<void> silence(int socket) const;

  /// Whether the own end of the connection `socket` has an address of one of these.
  bool carries(int socket) const;

 private:
  std::vector<unsigned> indices_;
  std::vector<std::string> addresses_;  // bytes as in the packets
};

}  // namespace robot::net
