#include "robot/game/control_listener.h"

#include <mutex>
#include <utility>

#include "robot/core/thread.h"
#include "robot/game/control_packet.h"

namespace robot::game {

Result<std::unique_ptr<ControlListener>> ControlListener::open(ListenerOptions options,
                                                               memory::MemoryObject<pb::GameState>& game,
                                                               const Clock& clock) {
  Result<UdpSocket> socket = UdpSocket::open(options.address, options.port);
  if (!socket) return socket.failure("GameController");
  return std::unique_ptr<ControlListener>(new ControlListener(std::move(*socket), options, game, clock));
}

ControlListener::ControlListener(UdpSocket socket, ListenerOptions options, memory::MemoryObject<pb::GameState>& game,
                                 const Clock& clock)
    : socket_(std::move(socket)), options_(options), game_(game), clock_(clock), thread_([this] { run(); }) {}

ControlListener::~ControlListener() {
  socket_.wake();
  thread_.join();
}

ListenerCounts ControlListener::counts() const {
  const std::lock_guard guard(lock_);
  return counts_;
}

std::optional<Endpoint> ControlListener::game_controller() const {
  const std::lock_guard guard(lock_);
  return game_controller_;
}

void ControlListener::run() {
  name_thread("game");
  while (const std::optional<Datagram> datagram = socket_.receive()) take(*datagram);
}

void ControlListener::take(const Datagram& datagram) {
  const std::uint64_t now_ns = clock_.now_ns();
  const Result<ControlPacket> packet = parse_control_packet(datagram.bytes);
  if (!packet) throttle_.report(Level::warning, "game", packet.error() + ", from " + text_of(datagram.from));
  std::optional<pb::GameState> game;
  if (packet) game = seen_by(*packet, options_.team, options_.player);
  if (game) {
    game->set_received_ns(now_ns);
    game_.write(*game, now_ns);
  }

  const std::lock_guard guard(lock_);
  counts_.told += game ? 1 : 0;
  counts_.foreign += packet && !game ? 1 : 0;
  counts_.refused += packet ? 0 : 1;
  if (game) game_controller_ = datagram.from;
}

}  // namespace robot::game
