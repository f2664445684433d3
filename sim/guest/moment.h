// Between our beliefs and commands and those of the C interface.
#pragma once

#include <cstdint>
#include <string>

#include "sim/agent/behaviour.h"
#include "sim/guest/foresight_behaviour.h"

namespace sim::guest {

ForesightPlayer player_of(const agent::Surroundings& surroundings, const agent::Game& game, std::uint64_t seed);

ForesightMoment moment_of(const agent::Game& game, const agent::Beliefs& beliefs, Tick now, bool entered);

/// What a guest is handed in: what is not changed stays so.
ForesightCommand usual_command(const agent::Mind& mind);

/// What is wrong with it: "body must be 0 .. 5, got 9"; empty where nothing is. `kicks`: how many there are.
std::string problem_of(const ForesightCommand& command, int kicks);

/// Our command, and what it says into the mind; of one without a problem.
motion::Command command_of(const ForesightCommand& command, const agent::Surroundings& surroundings,
                           const agent::Game& game, const agent::Beliefs& beliefs, Tick now, agent::Mind& mind);

}  // namespace sim::guest
