// The options of an environment, as a JSON object. All are optional:
//
//   {
//     "games": 1,                  // side by side
//     "drill": "empty_goal",       // name or file (sim/drills); without it, whole games from the kick-off
//     "rules": "spl2012", "models": "match", "players": 4, "home": "baseline", "away": "baseline",
//     "control": "home",           // the agents: the robots of "home", "away" or "both"; the others play their strategy
//     "actions": "menu",           // or "skills", "motion" (actions.h)
//     "frame": {…} or "mine.json", // menu, inputs and settings of a policy (sim/io/policy.h)
//     "ticks": 3,                  // [1/30 s] of one step
//     "seconds": 0,                // [s] of an episode; 0: by the drill, and without a drill a whole game
//     "every_tick": false,         // all robots decide 30 times a second, also far from the ball
//     "restart": "next_step"       // or "never"
//   }
//
// The options of the game replace those of the drill.
#pragma once

#include <string_view>

#include "robot/core/result.h"
#include "sim/agent/policy.h"
#include "sim/drills/drill.h"
#include "sim/environment/actions.h"

namespace sim::environment {

inline constexpr int kMostSideBySide = 100'000;

struct Options {
  int games = 1;
  int ticks = 3;
  bool restarts = true;                // a game that has ended begins anew in the next step
  bool controlled[2] = {true, false};  // by Side
  Kind actions = Kind::menu;
  bool has_start = false;  // the drill has starts
  drills::Drill drill;     // without one, a whole game: our goals count 1, their goals -1
  agent::Frame frame;
};

/// Reads the options. The Error is a sentence: "environment: ticks must be 1 .. 3000, got 0".
robot::Result<Options> read_options(std::string_view text);

}  // namespace sim::environment
