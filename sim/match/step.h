// The simulator on one screen.
#pragma once

#include "sim/agent/trace.h"
#include "sim/match/params.h"
#include "sim/match/state.h"
#include "sim/referee/event.h"

namespace sim {

/// The state in which a game begins. The rules say how many robots there are; the key says everything else.
State begin(const Params& params, RandomKey key, referee::Events& events);

inline constexpr int kEverybody = -2;

/// One tick, 1/30 s: perceive, decide, communicate, move, judge. Allocates nothing.
/// `traced` with `trace`: the decision of that robot in this tick is explained. kEverybody: `trace` is an array of
/// kMaxRobots, by index; who does not decide in this tick leaves his as it was.
void step(const Params& params, State& state, referee::Events& events, int traced = -1, agent::Trace* trace = nullptr);

/// The robot comes onto the field where its body stands, and begins anew: it knows roughly where that is, and nothing
/// else. `begin` and `step` do it where it is due; others after they placed a body.
void enter(const Params& params, State& state, int robot);

/// The game is over.
bool finished(const State& state);

}  // namespace sim
