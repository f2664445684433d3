// A simulated game that synthetic sensors look at.
#pragma once

#include <cstdint>
#include <deque>
#include <functional>
#include <memory>
#include <string>

#include "robot/core/lock.h"
#include "robot/core/result.h"
#include "sim/io/matchup.h"
#include "sim/match/state.h"

namespace robot::app {

struct WatchedGameOptions {
  sim::io::Matchup matchup;
  std::uint64_t seed = 1;      // of the first game; the next one follows it
  std::uint64_t begin_ns = 0;  // [ns since the epoch] time of the first game's first tick
};

/// A game that is played as far as somebody looks at it. The same options give the same worlds. Any thread.
class WatchedGame {
 public:
  /// Returns an Error for a wrong name of rules, strategies or models.
  static Result<std::unique_ptr<WatchedGame>> open(WatchedGameOptions options);

  /// Calls `on_tick` now with the newest world, and then in the thread that looks, once for each tick and in order, also for
  /// ticks that nobody looks at.
  using OnTick = std::function<void(const sim::World&, std::uint64_t capture_ns)>;
  void tell_ticks(OnTick on_tick);

  /// Returns the world at the newest tick that is not after `capture_ns`. Sensors may be up to kKept ticks apart; an older
  /// time gets the oldest kept world.
  sim::World at(std::uint64_t capture_ns);
  static constexpr std::size_t kKept = 60;

  const sim::field::Rules& rules() const { return game_.params.rules; }
  float ball_radius() const;  // [m]

 private:
  struct Seen {
    std::uint64_t capture_ns;
    sim::World world;
  };

  WatchedGame(WatchedGameOptions options, sim::io::PreparedGame game);

  void play_tick();
  void show();

  const WatchedGameOptions options_;
  const sim::io::PreparedGame game_;

  Mutex lock_;  // guards all below
  OnTick on_tick_;
  sim::State state_;
  std::uint64_t seed_;
  std::uint64_t ticks_ = 0;  // since begin_ns, of all games
  std::deque<Seen> seen_;    // the newest last
};

}  // namespace robot::app
