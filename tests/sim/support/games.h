// Games for tests, from the embedded descriptions.
#pragma once

#include <string>

#include "sim/io/matchup.h"
#include "sim/match/play.h"

namespace sim::test {

/// What `choice` names, in halves of `half` [s]: every kind of thing that happens in a game happens in a minute or two
/// too. A test fails when something is not there, and goes on with an empty setup.
io::PreparedGame setup_of(const io::Matchup& choice, float half = 600);

/// Both sides the same; at every tick, unless told otherwise.
io::Matchup choice_of(const std::string& rules, const std::string& strategy, const std::string& models,
                      Pace pace = Pace::every_tick);

/// The state `ticks` later, or at the end of the game.
State after(const Params& params, State state, Tick ticks);

/// A new game.
State begun(const Params& params, std::uint64_t seed);

/// Calls see(robot, body) for each robot that stands on the field.
template <class See>
void for_each_body(const World& world, See&& see) {
  for_each_robot(world.players, [&](int robot) {
    if (world.bodies[robot].doing != Body::Doing::removed) see(robot, world.bodies[robot]);
  });
}

}  // namespace sim::test
