// A robot in a real game. It follows the GameController, or the object `game` of the team's own code. Every half is
// recorded as a session of its own, and match mode holds meanwhile.
#pragma once

#include <memory>
#include <optional>
#include <string>

#include "robot/core/clock.h"
#include "robot/core/result.h"
#include "robot/game/control_listener.h"
#include "robot/game/match.h"
#include "robot/game/team_link.h"
#include "robot/logging/sessions/recorder.h"
#include "robot/memory/memory.h"
#include "robot/net/foxglove/parameters.h"

namespace robot::app {

/// The options of the game service.
struct GameOptions {
  std::optional<game::ListenerOptions> listener;  // not given: the team's own code writes the game state
  game::TeamLinkOptions link;                     // by default nothing is sent and the team's port is not opened
  std::string field;                              // name of the field for people: "A"; may be empty
  std::string profile = "game";  // of the recordings, until a client sets the parameter recording_profile
  bool practice = false;         // the first value of the parameter match_mode is the opposite: test games, no matches
};

/// The game in the status of the HTTP API.
struct GameStatus {
  std::string state;         // "initial", "standby", "ready", "set", "playing", "finished"; empty: no game state yet
  bool in_progress = false;  // from READY to FINISHED: a match, not a test
  bool match_mode = false;   // in progress, and the parameter match_mode is on: the league's rules hold
  bool practice = false;     // the parameter match_mode is off: wireless networks stay open in each game
  std::string warning;       // a second GameController, or a format that this program cannot read; empty: neither
  std::string stopped;       // reason why sending has stopped, one sentence; empty while sending works
};

/// The follower of a game, which records and declares match mode. follow() is called by one thread, status() by any.
///
/// A session that a client began is not touched: it contains the game, and the client ends it. If the disk does not permit
/// a session when the match begins, the session begins as soon as the disk does.
class GameService {
 public:
  /// All references outlive this. `memory` is that of our robot. Declares the parameter match_mode, which is on except
  /// with `practice`.
  GameService(GameOptions options, memory::Memory& memory, const Clock& clock, logging::Recorder& recorder,
              net::Parameters& parameters);

  /// Opens the ports that the options ask for. Returns an Error if a port cannot be opened.
  Result<void> start();

  /// Reads the game state. Begins a session when a match begins, and ends it with the match. Called at 10 Hz.
  void follow();

  GameStatus status() const;

 private:
  void begin_session(const foresight::GameState& game);
  void end_session();

  const GameOptions options_;
  memory::Memory& memory_;
  const Clock& clock_;
  logging::Recorder& recorder_;
  net::Parameters& parameters_;

  game::Match match_;
  std::optional<std::uint64_t> request_;  // number of the session that this service asked for
  std::unique_ptr<game::ControlListener> listener_;
  std::unique_ptr<game::TeamLink> link_;
};

}  // namespace robot::app
