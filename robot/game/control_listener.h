// Listens to the GameController and writes what it says into memory.
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

/// Where the GameController broadcasts to, twice a second: GAMECONTROLLER_DATA_PORT of all formats.
inline constexpr std::uint16_t kControlPort = 3838;

struct ListenerOptions {
  std::uint32_t team = 0, player = 0;  // ours
  std::uint32_t address = 0;           // to listen at, host byte order; 0: all of this machine's
  std::uint16_t port = kControlPort;   // 0: any
};

/// How many packets came and what became of them.
struct ListenerCounts {
  std::uint64_t told = 0;     // written into memory
  std::uint64_t foreign = 0;  // of a game of two other teams
  std::uint64_t refused = 0;  // not packets of the GameController; the last one's sentence is reported once a second
};

/// A thread of its own; it listens, and never sends. Every packet about our team becomes a version of `game`.
class ControlListener {
 public:
  /// Begins to listen; an Error if the port cannot be had. `game` and `clock` outlive the listener.
  static Result<std::unique_ptr<ControlListener>> open(ListenerOptions options,
                                                       memory::MemoryObject<pb::GameState>& game, const Clock& clock);
  ~ControlListener();
  ControlListener(const ControlListener&) = delete;
  ControlListener& operator=(const ControlListener&) = delete;

  std::uint16_t port() const { return socket_.port(); }

  /// Any thread.
  ListenerCounts counts() const;

  /// Who sent the last packet about our team; nothing before the first. Any thread.
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
