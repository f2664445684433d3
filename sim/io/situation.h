// A moment of a game as JSON: robots, ball, score and clock.
//
// {
//   "about": "two against the keeper", "seed": 7,
//   "phase": "playing", "set_play": "none", "kicking": "home",
//   "half": 1, "clock": 300, "score": {"home": 1, "away": 0},
//   "ball": {"x": 1.2, "y": 0.5, "velocity_x": 0, "velocity_y": 0},
//   "robots": [
//     {"side": "home", "player": 2, "x": 0.8, "y": 0.5, "heading": 0, "penalised": 0}, …
//   ]
// }
//
// Frame: field, which never flips: in the second half the home side attacks towards -x. Metres, seconds, radians.
// Required are the ball's x and y and each robot's side, player, x and y. `clock` is the time since the half began;
// `remaining`, the time to its end, may stand instead.
// "deviation" of ball or robot [m along each axis], "velocity_deviation" of the ball [m/s] and "heading_deviation" of a
// robot [rad] say how surely a place is known. They are standard deviations, and matter only where a start is shaken.
// `penalised` is the remaining time of a robot off the field. A robot that is not listed does not play. "check" makes the
// situation a test (sim/check/scenario.h), and is ignored here. "teams": {"home": 14, "away": 5} gives the
// teams their numbers; only events of "check" use them.
#pragma once

#include <string>
#include <string_view>

#include "robot/core/result.h"
#include "sim/foresight/situation.h"
#include "sim/io/json.h"
#include "sim/io/matchup.h"
#include "sim/match/state.h"

namespace sim::io {

class Reader;

/// The numbers of the two teams of a situation; 0: it names none.
struct SituationTeams {
  int home = 0, away = 0;

  int of(Side side) const { return side == Side::home ? home : away; }
};

/// Reads "teams" of a description. Gives the reader an error if they are no two different numbers in [1..999].
SituationTeams read_teams(Reader& reader, const Json& situation);

/// Makes the state of that moment, to be played on. All robots have just seen and reported the ball, and stand still.
/// `shaken` moves robots and ball by random amounts of that game, without overlaps. The amounts are normal ones of their
/// deviations; a ball with one stays between the lines. Without a deviation they are up to 0.3 m along each axis and 20
/// degrees. `turned` turns the field by half a turn and exchanges the sides: each side then has the other's moment, and
/// attacks the same goal as before.
robot::Result<State> parse_situation(std::string_view text, const std::string& called, const Params& params,
                                     const RandomKey* shaken = nullptr, bool turned = false);

/// Loads an embedded situation by name, or a file by path.
robot::Result<State> load_situation(const std::string& name, const Params& params);

/// Returns a description of the moment for parse_situation, with `about` unless it is empty.
///
/// It holds the true places of ball and robots, penalties, score, clock, phase and set play. It does not hold what the
/// robots believe, remember and do (walk, kick, squat, fall). Likewise not the age of a set play, the last touch, the
/// counts of the game and the walking referee. So a game that is played on from it is another game.
std::string save_situation(const State& state, const std::string& about = {});

/// Returns the same of a moment that a robot believes in, with the deviations of its beliefs. The robot's side is home,
/// and `teams` are named if both are known. A ball that may lie elsewhere is placed where it is believed.
std::string save_situation(const foresight::Situation& believed, SituationTeams teams, const std::string& about);

}  // namespace sim::io
