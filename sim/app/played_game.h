// One whole game as the commands play it: its report, and its recording.
#pragma once

#include <cstdint>
#include <functional>
#include <string>

#include "robot/bridge/simulated_game.h"
#include "robot/core/result.h"
#include "sim/app/progress.h"
#include "sim/contest/lineup.h"
#include "sim/contest/openings.h"
#include "sim/report/game_report.h"

namespace sim::app {

/// A requested recording, and its size after the game.
struct Recording {
  std::string path;
  robot::bridge::GameNames names;
  std::uint64_t messages = 0, size_bytes = 0;
};

/// The wishes about a game.
struct GameWish {
  std::uint64_t seed = 1;
  float seconds = 0;       // [s] longest game, dead time included; 0: to its end
  bool shoot_out = false;  // a drawn game is decided by a penalty shoot-out
};

/// Returns the shortest length of a game; dead time makes it longer.
Tick expected_ticks(const field::Rules& rules);

/// Returns the tick at which a game ends that lasts at most `seconds` from now; 0: kNever.
Tick end_of(const State& state, float seconds);

/// A game, with notes of the referee's decisions. The cast outlives it.
class NotedGame {
 public:
  State state;

  NotedGame(const contest::Cast& cast, const contest::Openings& openings, const GameWish& wish);

  /// Reports whether the wished length is not over yet.
  bool goes_on() const { return state.world.tick < end_; }
  /// Notes the decisions of the last step.
  void see(const referee::Events& events);
  /// Returns the report after the last step. Plays the shoot-out if there is one. Call once.
  report::GameReport report();

 private:
  const contest::Cast& cast_;
  const GameWish wish_;
  report::GameReport report_;
  Tick end_;
};

/// Plays a game, and records it unless `recording` is null. Updates `progress` unless it is null. Calls watch(state), unless
/// it is empty, at the beginning and after each tick. After an Error there is no file.
robot::Result<report::GameReport> play_one(const contest::Cast& cast, const contest::Openings& openings,
                                           const GameWish& wish, Recording* recording, ProgressBar* progress,
                                           const std::function<void(const State&)>& watch = {});

}  // namespace sim::app
