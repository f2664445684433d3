// What people may ask of a simulated game: services.
#pragma once

#include "robot/body/sim/sim_body.h"
#include "robot/net/foxglove/services.h"

namespace robot::app {

/// Adds the services, all of which answer as /sim/state does, or with one sentence that says why not:
///
///   /sim/state   {}                           {"ok", "paused", "finished", "speed", "seed", "tick", "seconds",
///                                              "ticks_behind", "rules", "home", "away"}; a team is
///                                              {"number", "strategy", "models", "score"}
///   /sim/pause   {}
///   /sim/resume  {}
///   /sim/step    {"ticks": 1}                 pauses, then plays 1 .. 1800 ticks at once; one if not given
///   /sim/speed   {"speed": 2}                 [game seconds per second] 0.1 .. 100
///   /sim/seed    {"seed": 7}                  a new game of that seed
///   /sim/reset   {"seed": 7, "situation": {…}}  a new game, of the same seed if none is given; from the situation
///                                              (sim/io/situation.h) instead of the kick-off if there is one
///
/// `body` outlives the server that uses them.
void add_simulation_service(body::SimBody& body, net::Services& services);

}  // namespace robot::app
