#include "robot/truth/feeds/ssl_vision_feed.h"

#include <utility>

namespace robot::truth {

Result<SslVisionFeed> SslVisionFeed::open(const MulticastAddress& address, const SslTeams& teams, const Clock& clock) {
  Result<MulticastSocket> socket = MulticastSocket::open(address);
  if (!socket) return socket.failure("SSL-Vision");
  return SslVisionFeed(std::move(*socket), address, teams, clock);
}

SslVisionFeed::SslVisionFeed(MulticastSocket socket, const MulticastAddress& address, const SslTeams& teams,
                             const Clock& clock)
    : socket_(std::move(socket)),
      place_("SSL-Vision " + address.group + ":" + std::to_string(socket_.port())),
      vision_(teams),
      clock_(clock) {}

Result<TimedTruth> SslVisionFeed::next() {
  const std::uint64_t deadline_ns = monotonic_ns() + kSecond;
  const std::uint64_t packets_before = vision_.counts().packets;
  std::string fault = "no image in it";  // why the last packet is of no use
  while (monotonic_ns() < deadline_ns) {
    const std::optional<MulticastSocket::Packet> packet = socket_.receive(deadline_ns);
    if (!packet) break;
    Result<std::optional<TimedTruth>> world = vision_.take(packet->bytes, clock_.now_ns() - packet->age_ns);
    if (!vision_.warning().empty()) warnings_.report(Level::warning, "ssl-vision", vision_.warning());
    if (world && *world) return **std::move(world);
    fault = world ? "no image in it" : world.error();
  }
  return nothing_came(vision_.counts().packets > packets_before, fault);
}

Error SslVisionFeed::nothing_came(bool packets, const std::string& fault) {
  if (packets) return Error{place_ + ": expected images, got packets of no use for a second; the last one: " + fault};
  if (const Result<void> joined = socket_.join(); !joined) return joined.failure(place_);
  return Error{place_ + ": expected packets, got none for a second"};
}

}  // namespace robot::truth
