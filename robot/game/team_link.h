// Answers to the GameController and messages to the teammates. No other part of the runtime sends during a match, and
// this part sends only what its options ask for.
#pragma once

#include <cstdint>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <thread>

#include "robot/core/clock.h"
#include "robot/core/lock.h"
#include "robot/core/report.h"
#include "robot/game/return_packet.h"
#include "robot/game/send_guard.h"
#include "robot/game/team_message.h"
#include "robot/game/udp_socket.h"
#include "robot/memory/memory.h"

namespace robot::game {

/// The settings of a TeamLink.
struct TeamLinkOptions {
  std::uint32_t team = 0, player = 0;       // ours
  bool return_packets = false;              // answer the GameController once a second
  bool team_messages = false;               // send to the teammates, as often as the budget allows
  std::uint32_t address = 0;                // local address to listen at, host byte order; 0: all
  std::uint32_t broadcast = 0xffff'ffff;    // destination of team messages, host byte order
  std::optional<std::uint16_t> port = {};   // of team messages; nothing: 10000 + team
  std::uint16_t return_port = kReturnPort;  // of answers
};

/// The link to teammates and GameController, with its own thread. It listens to the team's port, writes the object
/// `team`, and sends what the options ask for. When another program sends with our number, or the budget falls too
/// fast, it reports an error and sends nothing more.
class TeamLink {
 public:
  /// Starts the link. Returns an Error if the port cannot be opened. `memory` and `clock` outlive the link.
  /// `game_controller` returns the sender of the newest packet about us; the link's thread calls it.
  static Result<std::unique_ptr<TeamLink>> open(TeamLinkOptions options, memory::Memory& memory, const Clock& clock,
                                                std::function<std::optional<Endpoint>()> game_controller);
  ~TeamLink();
  TeamLink(const TeamLink&) = delete;
  TeamLink& operator=(const TeamLink&) = delete;

  std::uint16_t port() const { return socket_.port(); }

  /// Returns the reason why sending has stopped, in one sentence, or an empty string while it has not. Any thread.
  std::string stopped() const;

 private:
  TeamLink(UdpSocket socket, TeamLinkOptions options, memory::Memory& memory, const Clock& clock,
           std::function<std::optional<Endpoint>()> game_controller);

  void run();
  void take(const Datagram& datagram);
  void take_message(const TeamMessage& message, std::uint64_t now_ns);
  void follow_game();
  void answer();
  void tell_teammates();
  void write_team();

  UdpSocket socket_;
  const TeamLinkOptions options_;
  memory::Memory& memory_;
  const Clock& clock_;
  const std::function<std::optional<Endpoint>()> game_controller_;
  const std::uint32_t sender_;  // distinguishes our messages from those of a second program with our number

  Throttle throttle_;

  // used by the thread alone; times by monotonic_ns()
  SendGuard guard_;
  std::uint64_t game_sequence_ = 0;
  std::uint64_t last_answer_ns_ = 0, last_message_ns_ = 0, last_written_ns_ = 0;
  std::map<std::uint32_t, pb::Teammate> teammates_;
  std::uint64_t sent_ns_ = 0;
  std::uint32_t messages_sent_ = 0, messages_wrong_ = 0;

  mutable Mutex lock_;
  std::string stopped_;

  std::thread thread_;
};

}  // namespace robot::game
