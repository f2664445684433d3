// Played games for the tests of the debugger.
#pragma once

#include <functional>

#include "sim/debug/decision.h"
#include "sim/io/situation.h"
#include "tests/sim/support/games.h"

namespace sim::debug::test {

inline constexpr io::SituationTeams kTeams{.home = 14, .away = 5};

/// Returns the setup of a game of these strategies with halves of `half` [s].
SharedSetup setup_of(const std::string& home, const std::string& away, float half = 60);
/// Returns the timeline of a new game.
Timeline timeline_of(const SharedSetup& setup, std::uint64_t seed);

/// Calls see(state, decision, behaviour) for decisions in play of all robots, one of every `every`, until there were
/// `count`. Plays several games if needed.
void for_each_decision(
    int count, int every,
    const std::function<void(const Params&, const State&, const Decision&, const agent::TreeBehaviour&)>& see);

}  // namespace sim::debug::test
