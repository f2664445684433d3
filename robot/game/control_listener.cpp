#include "robot/game/control_listener.h"

#include <mutex>
#include <utility>

#include "robot/core/attempt.h"
#include "robot/core/thread.h"
#include "robot/game/control_layout.h"
#include "robot/game/control_packet.h"

namespace robot::game {

Result<std::unique_ptr<ControlListener>> ControlListener::open(ListenerOptions options,
                                                               memory::MemoryObject<pb::GameState>& game,
                                                               const Clock& clock) {
  Result<UdpSocket> socket = UdpSocket::open(options.address, options.port);
  if (!socket) return socket.failure("GameController");
  std::unique_ptr<ControlListener> made(new ControlListener(std::move(*socket), options, game, clock));
  if (Result<void> started = start_thread(made->thread_, "game", [listener = made.get()] { listener->run(); });
      !started)
    return started.failure();
  return made;
}

ControlListener::ControlListener(UdpSocket socket, ListenerOptions options, memory::MemoryObject<pb::GameState>& game,
                                 const Clock& clock)
    : socket_(std::move(socket)), options_(options), game_(game), clock_(clock) {}

ControlListener::~ControlListener() {
  socket_.wake();
  if (thread_.joinable()) thread_.join();
}

ListenerCounts ControlListener::counts() const {
  const std::lock_guard guard(lock_);
  return counts_;
}

std::optional<Endpoint> ControlListener::game_controller() const {
  const std::lock_guard guard(lock_);
  return followed_ ? std::optional(followed_->from) : std::nullopt;
}

std::string ControlListener::warning() const {
  const std::uint64_t now_ns = clock_.now_ns();
  const std::lock_guard guard(lock_);
  return now_ns < warning_.last_ns + kFollowedSilenceNs ? warning_.sentence : "";
}

void ControlListener::run() {
  name_thread("game");
  while (const std::optional<Datagram> datagram = socket_.receive())
    if (const Result<void> taken = attempt("reading a packet", [&] { take(*datagram); }); !taken)
      throttle_.report(Level::error, "game", taken.error());
}

void ControlListener::take(const Datagram& datagram) {
  const std::uint64_t now_ns = clock_.now_ns();
  const Result<ControlPacket> packet = parse_control_packet(datagram.bytes);
  if (packet) {
    if (auto game = seen_by(*packet, options_.team, options_.player))
      return take_game(std::move(*game), datagram.from, now_ns);
    const std::lock_guard guard(lock_);
    ++counts_.foreign;
    return;
  }
  if (auto game = unreadable_game(datagram.bytes, options_.team, options_.player))
    return take_unreadable(std::move(*game), datagram.from, now_ns);
  throttle_.report(Level::warning, "game", packet.error() + ", from " + text_of(datagram.from));
  const std::lock_guard guard(lock_);
  ++counts_.refused;
}

void ControlListener::take_game(pb::GameState game, const Endpoint& from, std::uint64_t now_ns) {
  if (follows_another(from, now_ns)) {
    warn("two GameControllers send for team " + std::to_string(options_.team) + ": " + text_of(followed_->from) +
             " is followed, " + text_of(from) + " is ignored until the first is silent",
         now_ns);
    const std::lock_guard guard(lock_);
    ++counts_.second;
    return;
  }
  write(std::move(game), now_ns);
  const std::lock_guard guard(lock_);
  ++counts_.told;
  followed_ = {from, now_ns};
}

void ControlListener::take_unreadable(pb::GameState game, const Endpoint& from, std::uint64_t now_ns) {
  const std::uint32_t version = game.packet_version();
  const std::string format = "GameController format " + std::to_string(version);
  const std::string reason = version > kNewestVersion
                                 ? " is newer than this program (" + std::to_string(kOldestVersion) + " .. " +
                                       std::to_string(kNewestVersion) + ")"
                                 : " has a length that this program does not know";
  const bool second = follows_another(from, now_ns);
  if (!second) write(std::move(game), now_ns);
  warn(format + reason + "; it comes from " + text_of(from) +
           (second ? " and is ignored" : ", and a match counts as in progress"),
       now_ns);
  const std::lock_guard guard(lock_);
  ++(second ? counts_.second : counts_.told);
}

bool ControlListener::follows_another(const Endpoint& from, std::uint64_t now_ns) const {
  if (!followed_ || followed_->from == from) return false;
  const bool restarted = followed_->from.address == from.address;
  return now_ns < followed_->last_ns + (restarted ? kRestartSilenceNs : kFollowedSilenceNs);
}

void ControlListener::write(pb::GameState game, std::uint64_t now_ns) {
  game.set_received_ns(now_ns);
  game_.write(game, now_ns);
}

void ControlListener::warn(std::string sentence, std::uint64_t now_ns) {
  const std::lock_guard guard(lock_);
  const bool repeated = sentence == warning_.sentence && now_ns < warning_.last_ns + kFollowedSilenceNs;
  if (!repeated) report(Level::warning, "game", sentence);
  warning_ = {std::move(sentence), now_ns};
}

}  // namespace robot::game
