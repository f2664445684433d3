// The positions in a session, as windows for the statistics of a game.
#pragma once

#include <vector>

#include "robot/core/result.h"
#include "robot/logging/sessions/session.h"
#include "sim/statistics/window.h"

namespace robot::app {

/// Returns the windows in /truth/world of a session, each with statistics::kWindowFrames frames in play. The last one
/// may be shorter, but has at least a minute in play.
///
/// In play is the time in which a recorded game state is PLAYING, or all time without one. Robots need team and number;
/// the sides are the two teams that are seen most. Returns an Error if there is no minute in play or no second team.
Result<std::vector<sim::statistics::Window>> windows_of(const logging::Session& session);

}  // namespace robot::app
