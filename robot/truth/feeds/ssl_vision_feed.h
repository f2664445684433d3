// Ground truth of an SSL-Vision on the network.
#pragma once

#include <string>

#include "robot/core/clock.h"
#include "robot/core/report.h"
#include "robot/core/result.h"
#include "robot/truth/feeds/multicast_socket.h"
#include "robot/truth/feeds/ssl_vision.h"

namespace robot::truth {

/// The worlds of an SSL-Vision, as its packets come. Used by one thread.
class SslVisionFeed {
 public:
  /// Joins the group. Returns an Error if that is not possible. `clock` is the time base of the worlds and outlives this.
  static Result<SslVisionFeed> open(const MulticastAddress& address, const SslTeams& teams, const Clock& clock);

  /// Waits for the next world, at most a second. Returns an Error for each second without one: nothing comes, or the
  /// reason why the packets are of no use. It then joins the group again, so an unplugged network comes back by itself.
  /// An odd packet, such as one with an id that is no player, is reported at most once a second.
  Result<TimedTruth> next();

  std::uint16_t port() const { return socket_.port(); }
  const SslVisionCounts& counts() const { return vision_.counts(); }

  /// Returns the size of the field, or nothing before SSL-Vision has sent it.
  const std::optional<SslField>& field() const { return vision_.field(); }

 private:
  SslVisionFeed(MulticastSocket socket, const MulticastAddress& address, const SslTeams& teams, const Clock& clock);

  Error nothing_came(bool packets, const std::string& fault);

  MulticastSocket socket_;
  const std::string place_;  // for sentences
  SslVision vision_;
  const Clock& clock_;
  Throttle warnings_;
};

}  // namespace robot::truth
