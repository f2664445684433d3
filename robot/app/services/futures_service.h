// The services of the debugger that change a moment and play on: the futures with and without a change.
#pragma once

#include <string>
#include <vector>

#include "robot/body/sim/sim_body.h"
#include "robot/memory/channels.h"
#include "robot/net/foxglove/services.h"

namespace robot::app {

struct FuturesOptions {
  std::vector<std::string> strategies;  // by name or path, beside the embedded ones
  std::string rules;                    // empty: those of the simulation, or the newest of a real game
  body::SimBody* game = nullptr;        // the simulated game that this process plays; it outlives the server
};

/// Adds this question about the robots in `channels`, which outlive the server:
///
///   /decision/futures  {"robot": "14/2", "edits": ["set ball 1 0.5", …], "pairs": 200, "seconds": 30, …}
///
/// The edits are lines of the debugger (sim/debug/commands.h): `set` and `strategy`, at most kMostEdits. A strategy is an
/// embedded one or one of the options. The game goes on `pairs` (2 .. kMostPairs, or 0 for none) times with and without
/// them, each for `seconds` (1 .. 120), at most kMostPlayed pair-seconds in all.
///
/// With `game` the moment is that of the game itself, agents' memories included, at "tick" of the game of "seed", by default
/// now. With "objects" (robot/app/asked_moment.h) of a recorded game it is the same, if that game can be played again
/// (robot/app/replayed_game.h). Otherwise it is what the robot believed, whose own side is home.
/// Then each pair has its own draw of what is uncertain, but the first one has the most likely places. The opponents play
/// "baseline". The answer:
///
///   {"ok", "from": "game" | "beliefs", "tick": of the game | null, "robot", "side": "home" | "away", "attacks": 1 | -1,
///    "before": places, "after": places, "strategies": […], "leaves": [{"path", "arguments": [{"name", "value"}]}],
///    "futures": null | sim/report/futures_report.h}
///
/// Places are {"ball": {"x", "y"}, "robots": [{"name", "side", "x", "y", "heading"}]} [m, rad, field] of the first pair,
/// without and with the edits. "leaves" are those of the robot's tree, with the edits.
///
/// With `game` also this, for control:
///
///   /sim/edit  {"robot": "14/2", "edits": […], "tick": 1500}  -> {"ok"}
///
/// It pauses the game and changes it at its present tick, which must be "tick". A running game keeps its trees, so here the
/// edits are those of places, beliefs and luck.
///
/// In a program that was linked without reasons (robot_no_reasons), neither is added.
void add_futures_service(net::Services& services, const memory::Channels& channels, const FuturesOptions& options);

inline constexpr int kMostEdits = 50, kMostPairs = 1000, kMostPlayed = 30'000;

}  // namespace robot::app
