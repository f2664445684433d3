// The effect of a change on a game's futures as JSON, for the viewer and for programs.
#pragma once

#include "sim/debug/futures.h"
#include "sim/report/game_report.h"

namespace sim::report {

/// Returns futures of `length` [ticks]. Times are in s, places in m. Frame: field.
///
///   "pairs", "different": numbers of pairs, and of those in which anything differs. "seconds": the length.
///
///   "scores", "concedes", "goals": {"without", "with", "low", "high"}. The first two are shares [0..1] of futures, the
///   third is the goal difference. "low" and "high" are the 95 % interval of the difference.
///
///   "parting": {"seconds", "field"}, in the pair with the luck of the game: the time behind the moment of the first
///   difference, and its place in the State. Null without a difference.
///
///   "spacing": [s] between two points of a path. "paths": {"without": [{"ball": [x, y, …], "robot": [x, y, …]}, …],
///   "with": likewise}. Paths with the same index have the same luck.
Json to_json(const debug::Futures& futures, Tick length);

}  // namespace sim::report
