// One step of a game: the simulator on one screen.
#pragma once

#include <cstddef>
#include <span>

#include "sim/agent/trace.h"
#include "sim/match/params.h"
#include "sim/match/state.h"
#include "sim/referee/event.h"

namespace sim {

/// Returns the state at the start of a game. The rules give the number of robots, the key settles everything random.
State begin(const Params& params, RandomKey key, referee::Events& events);

inline constexpr int kEverybody = -2;  // for `traced`: trace all robots

/// Plays one tick, 1/30 s: perceive, decide, communicate, move, judge. Allocates nothing.
///
/// Writes the decision trace of robot `traced` to `trace`. With kEverybody, `trace` is an array of kMaxRobots traces by
/// index. A robot that does not decide in this tick leaves its trace unchanged.
void step(const Params& params, State& state, referee::Events& events, int traced = -1, agent::Trace* trace = nullptr);

/// The most games that one pass takes together.
inline constexpr std::size_t kMostGames = 64;
/// The number of games that are usually played together: more fill the lanes no better.
inline constexpr std::size_t kTogether = 32;

/// Plays one tick of each game, to the same bits as `step`. Writes the events of games[i] to events[i]. The games share
/// their parameters, but not their ticks. Most efficient with 16 to kMostGames games. Allocates nothing.
void step_many(const Params& params, std::span<State* const> games, std::span<referee::Events> events);

/// Lets a robot enter the field at the place of its body. All it knows is roughly where it stands.
/// `begin` and `step` call this themselves; other code calls it after placing a body.
void enter(const Params& params, State& state, int robot);

/// Reports whether the game is over.
bool finished(const State& state);

}  // namespace sim
