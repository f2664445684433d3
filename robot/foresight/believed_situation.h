// A robot's beliefs as the start of simulated games.
#pragma once

#include <string>

#include "robot/bridge/from_messages.h"
#include "robot/core/result.h"
#include "sim/match/params.h"

namespace robot::foreseeing {

/// Returns the moment that the robot believes in as a situation of the simulator (sim/io/situation.h), with `about`. Its own
/// side is home. Uncertain places have a deviation, with which `--fuzz` varies the start of each game. `params` are the
/// rules of the game and, as the home team, the abilities of the robot. Returns an Error when there is no such moment: the
/// robot does not know where it is, nobody has seen the ball, or no soccer is played.
Result<std::string> believed_situation(const bridge::Recollection& recollection, const sim::Params& params,
                                       const std::string& about);

}  // namespace robot::foreseeing
