// Services by which clients control a simulated game.
#pragma once

#include "robot/body/sim/sim_body.h"
#include "robot/net/foxglove/services.h"

namespace robot::app {

/// Adds these services. All answer like /sim/state, or with one sentence that names the error:
///
///   /sim/state   {}                           {"ok", "paused", "finished", "speed", "seed", "tick", "seconds",
///                                              "ticks_behind", "rules", "home", "away"}; a team is
///                                              {"number", "strategy", "models", "score"}
///   /sim/pause   {}
///   /sim/resume  {}
///   /sim/step    {"ticks": 1}                 pauses, then plays 1 .. 1800 ticks at once, by default one
///   /sim/back    {"ticks": 30}                pauses, and returns the game to the tick that many ticks before
///   /sim/speed   {"speed": 2}                 [game seconds per second] 0.1 .. 100
///   /sim/seed    {"seed": 7}                  begins a new game of that seed
///   /sim/reset   {"seed": 7, "situation": {…}}  begins a new game, by default of the same seed and from the kick-off;
///                                              with a situation (sim/io/situation.h) from there
///
/// The situation may also be the name of an embedded one, such as "blocked". It is never a path.
/// `body` outlives the server that uses them.
void add_simulation_service(body::SimBody& body, net::Services& services);

}  // namespace robot::app
