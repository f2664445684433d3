// Receives the packets of the GameController and writes them into memory.
#pragma once

#include <atomic>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <thread>

#include "proto/foresight/game.pb.h"
#include "robot/core/clock.h"
#include "robot/core/lock.h"
#include "robot/core/report.h"
#include "robot/game/udp_socket.h"
#include "robot/memory/memory_object.h"

namespace robot::game {

namespace pb = foresight;

/// The port to which the GameController broadcasts twice a second: GAMECONTROLLER_DATA_PORT of all formats.
inline constexpr std::uint16_t kControlPort = 3838;

/// The GameController that is followed keeps its place until it is silent for this time [ns]. It sends twice a second.
inline constexpr std::uint64_t kFollowedSilenceNs = 10'000'000'000;

/// The same against a sender with the same address and another port: a GameController that was started again [ns].
inline constexpr std::uint64_t kRestartSilenceNs = 2'000'000'000;

/// The settings of a ControlListener.
struct ListenerOptions {
  std::uint32_t team = 0, player = 0;  // ours
  std::uint32_t address = 0;           // local address to listen at, host byte order; 0: all
  std::uint16_t port = kControlPort;   // 0: any
};

/// Counts of the packets that came.
struct ListenerCounts {
  std::uint64_t told = 0;     // written into memory
  std::uint64_t foreign = 0;  // of a game between two other teams
  std::uint64_t second = 0;   // about our team, but not from the GameController that is followed
  std::uint64_t refused = 0;  // not packets of the GameController; reported at most once a second
};

/// A receiver of the GameController's packets, with its own thread. It never sends.
/// Every packet about our team becomes a version of `game`, if it is from the GameController that is followed: the first
/// one that sent such a packet. Another one is refused until the first is silent. So a laptop that was
/// left on cannot end a match. A packet in an unreadable format counts only while no readable one is followed.
class ControlListener {
 public:
  /// Starts to listen. Returns an Error if the port cannot be opened. `game` and `clock` outlive the listener.
  static Result<std::unique_ptr<ControlListener>> open(ListenerOptions options,
                                                       memory::MemoryObject<pb::GameState>& game, const Clock& clock);
  ~ControlListener();
  ControlListener(const ControlListener&) = delete;
  ControlListener& operator=(const ControlListener&) = delete;

  std::uint16_t port() const { return socket_.port(); }

  /// Returns the counts so far. Any thread.
  ListenerCounts counts() const;

  /// Returns the GameController that is followed, or nothing before its first packet. Any thread.
  std::optional<Endpoint> game_controller() const;

  /// Returns a sentence about a second GameController or an unreadable format that came in the last 10 s, or an empty
  /// string. Any thread.
  std::string warning() const;

 private:
  ControlListener(UdpSocket socket, ListenerOptions options, memory::MemoryObject<pb::GameState>& game,
                  const Clock& clock);

  /// The sender of a packet and the time of its last one.
  struct Followed {
    Endpoint from;
    std::uint64_t last_ns;
  };
  /// A fault that is shown until it is kFollowedSilenceNs old.
  struct Warning {
    std::string sentence;
    std::uint64_t last_ns = 0;
  };

  void run();
  void take(const Datagram& datagram);
  void take_game(pb::GameState game, const Endpoint& from, std::uint64_t now_ns);
  void take_unreadable(pb::GameState game, const Endpoint& from, std::uint64_t now_ns);
  bool follows_another(const Endpoint& from, std::uint64_t now_ns) const;
  void write(pb::GameState game, std::uint64_t now_ns);
  void warn(std::string sentence, std::uint64_t now_ns);

  UdpSocket socket_;
  const ListenerOptions options_;
  memory::MemoryObject<pb::GameState>& game_;
  const Clock& clock_;
  Throttle throttle_;

  mutable Mutex lock_;
  ListenerCounts counts_;
  std::optional<Followed> followed_;
  Warning warning_;

  std::thread thread_;
};

}  // namespace robot::game
