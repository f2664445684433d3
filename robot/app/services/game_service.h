// A robot in a real game: the GameController is heard, or the team's own code that hears it; every half is recorded as a
// session of its own; meanwhile it is match mode.
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

struct GameOptions {
  std::optional<game::ListenerOptions> listener;  // nothing: the team's own code writes the game state
  game::TeamLinkOptions link;    // nothing is sent, and the team's port not listened to, unless it asks for something
  std::string field;             // which one, for people: "A"; may be empty
  std::string profile = "game";  // how halves are recorded, until somebody sets the parameter recording_profile
};

/// What the status tells of the game.
struct GameStatus {
  std::string state;         // "initial", "standby", "ready", "set", "playing", "finished"; empty: nothing heard yet
  bool in_progress = false;  // from READY to FINISHED: a match, not a test
  bool match_mode = false;   // so the rules of the league hold, unless the parameter match_mode says otherwise
  std::string stopped;       // why nothing is sent any more, one sentence; empty while all is well
};

/// follow() belongs to one thread, status() to any.
///
/// A session that somebody else began is left alone: the game is in it, and whoever began it ends it.
class GameService {
 public:
  /// The given ones outlive this; `memory` is that of our robot. Declares the parameter match_mode, on by default.
  GameService(GameOptions options, memory::Memory& memory, const Clock& clock, logging::Recorder& recorder,
              net::Parameters& parameters);

  /// Begins to listen, where that is asked for; an Error, in one sentence, if the port cannot be had.
  Result<void> start();

  /// Looks at the game; begins a session when a match begins and ends it with the match. A few times a second.
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
  std::optional<std::string> session_;  // the one begun here
  std::unique_ptr<game::ControlListener> listener_;
  std::unique_ptr<game::TeamLink> link_;
};

}  // namespace robot::app
