// A moment of a game as JSON: who stands where, what the ball does, score and clock.
//
// {
//   "about": "two against the keeper", "seed": 7,
//   "phase": "playing", "set_play": "none", "kicking": "home",
//   "half": 1, "clock": 300, "score": {"home": 1, "away": 0},
//   "ball": {"x": 1.2, "y": 0.5, "velocity_x": 0, "velocity_y": 0},
//   "robots": [{"side": "home", "player": 2, "x": 0.8, "y": 0.5, "heading": 0, "penalised": 0}, …]
// }
//
// Frame: field, which never flips: in the second half the home side attacks towards -x. Metres, seconds, radians.
// Only the ball's x and y and each robot's side, player, x and y must be there. `clock` is how much of the half has run,
// `penalised` for how much longer a robot is kept off the field. A robot that is not named does not play at all.
#pragma once

#include <string>
#include <string_view>

#include "robot/core/result.h"
#include "sim/io/matchup.h"
#include "sim/match/state.h"

namespace sim::io {

/// The state in which that moment is played on. Everybody has just seen the ball and told the others, and stands still.
/// `shaken`: everybody and the ball stand a little elsewhere, up to 0.3 m along each axis and 20 degrees, as that game's
/// luck has it; nobody on top of another.
robot::Result<State> parse_situation(std::string_view text, const std::string& called, const Params& params,
                                     const RandomKey* shaken = nullptr);

/// An embedded situation by name, or the file at a path.
robot::Result<State> load_situation(const std::string& name, const Params& params);

/// A description that parse_situation makes the same moment of, beliefs and motion of the robots apart.
std::string save_situation(const State& state);

}  // namespace sim::io
