// A moment of a recorded session: its time, its game, and the situation that a robot believed in.
#pragma once

#include <cstdint>
#include <string>

#include "robot/core/result.h"
#include "robot/foresight/game_setting.h"
#include "robot/logging/sessions/session.h"

namespace robot::app {

/// Returns the time [ns since the epoch] that is `at` [s] after the beginning of the session or, below 0, before its end.
/// Returns an Error for a time outside the session.
Result<std::uint64_t> time_in(const logging::Session& session, double at);

/// Returns the rules and models of `robot` in the recorded simulation, or those of a real game. `rules` replace the rules,
/// unless they are empty.
foreseeing::GameSetting recorded_setting(const logging::Session& session, const std::string& robot,
                                         const std::string& rules);

struct RecordedMoment {
  std::string robot;  // "14/2"; empty: the robot that recorded the session
  double at = 0;      // [s] as in time_in
  std::string rules;  // empty: those of the recorded simulation, else spl2025
};

/// Returns what the robot believed at that moment as a situation of the simulator (robot/foresight/believed_situation.h).
Result<std::string> situation_at(const logging::Session& session, const RecordedMoment& moment);

}  // namespace robot::app
