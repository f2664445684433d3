// Receives the packets of the GameController and writes them into memory.
#pragma once

#include <atomic>
#include <cstdint>
#include <memory>
#include <optional>
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
  std::uint64_t refused = 0;  // not packets of the GameController; reported at most once a second
};

/// A receiver of the GameController's packets, with its own thread. It never sends.
/// Every packet about our team becomes a version of `game`.
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

  /// Returns the sender of the last packet about our team, or nothing before the first. Any thread.
  std::optional<Endpoint> game_controller() const;

 private:
  ControlListener(UdpSocket socket, ListenerOptions options, memory::MemoryObject<pb::GameState>& game,
                  const Clock& clock);

  void run();
  void take(const Datagram& datagram);

  UdpSocket socket_;
  const ListenerOptions options_;
  memory::MemoryObject<pb::GameState>& game_;
  const Clock& clock_;
  Throttle throttle_;

  mutable Mutex lock_;
  ListenerCounts counts_;
  std::optional<Endpoint> game_controller_;

  std::thread thread_;
};

}  // namespace robot::game
