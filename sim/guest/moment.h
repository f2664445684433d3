// Conversion between our beliefs and commands and those of the C interface.
#pragma once

#include <cstdint>
#include <string>

#include "sim/agent/behaviour.h"
#include "sim/guest/foresight_behaviour.h"

namespace sim::guest {

ForesightPlayer player_of(const agent::Surroundings& surroundings, const agent::Game& game, std::uint64_t seed);

ForesightMoment moment_of(const agent::Game& game, const agent::Beliefs& beliefs, Tick now, bool entered);

/// Returns the default command that a guest may change.
ForesightCommand usual_command(const agent::Mind& mind);

/// Returns an error such as "body must be 0 .. 5, got 9", or an empty text. `kicks` is the number of kicks.
std::string problem_of(const ForesightCommand& command, int kicks);

/// Converts a command without errors to ours, and updates the mind.
motion::Command command_of(const ForesightCommand& command, const agent::Surroundings& surroundings,
                           const agent::Game& game, const agent::Beliefs& beliefs, Tick now, agent::Mind& mind);

}  // namespace sim::guest
