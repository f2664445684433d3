// A recorded session as positions for the simulator.
#pragma once

#include <array>
#include <cstdint>
#include <string>

#include "robot/bridge/to_messages.h"
#include "robot/core/result.h"
#include "robot/logging/sessions/session.h"
#include "sim/replay/replay.h"

namespace sim::app {

/// The positions in a session, and the names of its teams and players.
struct RecordedGame {
  replay::Recording recording;
  robot::bridge::TeamNumbers teams;
  std::array<std::uint32_t, kMaxRobots> players = {};  // jersey number by index in the simulator; 0: none
};

/// The teams of a session. 0: by the recording.
struct WantedTeams {
  std::uint32_t home = 0, away = 0;
};

/// Returns the rules that a recorded simulation names, or an empty text.
std::string recorded_rules(const robot::logging::Session& session);

/// Reads /truth/world of a session, for `players` [1..7] a side. The home side is that of the recorded simulation;
/// without one it is the lower number of the two teams that are seen most. Players keep their numbers; larger numbers
/// get the places that are free. Returns an Error without ground truth, without two teams, or for a recording of more
/// than six hours.
robot::Result<RecordedGame> read_recorded_game(const robot::logging::Session& session, int players,
                                               const WantedTeams& wanted);

}  // namespace sim::app
