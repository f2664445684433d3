// Drills as JSON: short games that practise and measure one thing.
//
//   {
//     "about": "one striker, no opponent",
//     "home": "baseline", "away": "baseline", "rules": "spl2012", "models": "match", "players": 4,
//     "seconds": 20,
//     "start": {                                // a situation (sim/io/situation.h), with ranges
//       "ball": {"x": [0, 1], "y": [-1, 1]},
//       "robots": [{"side": "home", "player": 2, "x": [-1, -0.5], "y": [-1, 1], "heading": [-0.5, 0.5]}]
//     },
//     "ball_known": true,
//     "success": "our goal",
//     "failure": "ball out or their goal",
//     "time_over": "failure",
//     "score": {"our shot": 0.2},
//     "progress": {"ball_x": 0.1}
//   }
//
// The home side practises. A number of ball or robot may be a range [least, most]: each start draws it, all values alike.
// With "ball_known": false nobody has seen the ball. Success and failure are conditions (sim/check/condition.h) that come
// true: without "always", "never" and "not". At "seconds" the attempt ends as "time_over" says.
//
// The score of an attempt has three parts. Success gives 1. A fact of "score" gives its points each time it comes true. A
// quantity of "progress" gives its points for each unit by which it grows before the last tick. Required are "start", "seconds" and "success"; the other
// defaults are those above, without failure, score and progress.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "robot/core/result.h"
#include "sim/check/condition.h"
#include "sim/io/matchup.h"
#include "sim/match/state.h"

namespace sim::drills {

/// The points for a fact each time it comes true.
struct Points {
  check::Fact fact;
  float points = 0;
};

/// The points for each unit by which a quantity grows.
struct Progress {
  int quantity = 0;
  float points = 0;
};

/// A drill. Immutable: any number of attempts share it.
struct Drill {
  std::string name;
  std::string about;
  io::Matchup game;
  Tick duration = 0;             // of the longest attempt
  std::string least, most;       // the situation with all ranges at their least and at their greatest values
  bool ball_known = true;        // all robots have seen the ball at the start
  check::Condition success;      // ends an attempt
  check::Condition failure;      // likewise, unless success does in the same tick; without alternatives: never
  bool time_is_success = false;  // an attempt whose time is over succeeds
  std::vector<Points> score;
  std::vector<Progress> progress;
};

/// Parses a drill. `called` opens the sentence of an Error, which names the place: "drill 'mine.json': success: …".
robot::Result<Drill> parse_drill(std::string_view text, const std::string& called);

/// Loads an embedded drill by name, or a file by path. Checks its start under its own rules and models.
robot::Result<Drill> load_drill(const std::string& name);

}  // namespace sim::drills
