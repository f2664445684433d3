// Games for tests, from the embedded descriptions.
#pragma once

#include <string>

#include "sim/io/matchup.h"
#include "sim/match/play.h"

namespace sim::test {

/// Prepares the game of `matchup`, with halves of `half` [s]: a minute or two already holds every kind of event. If a
/// name is unknown, the test fails and goes on with an empty game.
io::PreparedGame setup_of(const io::Matchup& matchup, float half = 600);

/// Returns a matchup with the same strategy and models on both sides.
io::Matchup choice_of(const std::string& rules, const std::string& strategy, const std::string& models,
                      Pace pace = Pace::every_tick);

/// Returns the state `ticks` later, or at the end of the game.
State after(const Params& params, State state, Tick ticks);

/// Returns the first state of a new game.
State begun(const Params& params, std::uint64_t seed);

/// Calls see(robot, body) for each robot that stands on the field.
template <class See>
void for_each_body(const World& world, See&& see) {
  for_each_robot(world.players, [&](int robot) {
    if (on_field(world.bodies[robot])) see(robot, world.bodies[robot]);
  });
}

}  // namespace sim::test
