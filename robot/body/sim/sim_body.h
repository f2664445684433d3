// The body that is a simulated game: all its robots, of which this process is one.
#pragma once

#include <cstdint>
#include <memory>
#include <thread>

#include "proto/foresight/sim.pb.h"
#include "robot/body/sim/game.h"
#include "robot/body/sim/memories.h"
#include "robot/body/sim/pacer.h"
#include "robot/core/clock.h"
#include "robot/core/lock.h"
#include "robot/core/result.h"
#include "robot/memory/channels.h"
#include "robot/memory/memory.h"

namespace robot::body {

struct SimOptions {
  int robot = 1;           // index of the robot that this process is
  std::uint64_t seed = 1;  // of the first game, 0 .. SimBody::kGreatestSeed
  double speed = 1;        // [game seconds per second] Pacer::kSlowest .. kFastest
  bool loop = false;       // another game, of the next seed, follows `rest_ns` after the end
  std::uint64_t rest_ns = 5 * kSecond;
};

/// Plays in a thread of its own and writes every robot's memory. Orders are done when they return, and memory tells it.
/// Any thread.
class SimBody {
 public:
  static constexpr std::uint64_t kGreatestSeed = (std::uint64_t{1} << 53) - 1;  // a number that JSON keeps exact
  static constexpr std::int64_t kMostSteps = 1800;                              // a minute at once

  /// Stands at the beginning of the first game. `clock` outlives the body. An Error if an option is out of range.
  static Result<std::unique_ptr<SimBody>> open(Setup setup, SimOptions options, const SessionClock& clock);

  /// As stop().
  ~SimBody();

  /// This process's own.
  const std::shared_ptr<memory::Memory>& memory() const { return memories_.own(); }

  /// Lists what is simulated in `channels`.
  Result<void> list(memory::Channels& channels) const { return memories_.list(channels); }

  /// Plays from now on. Once.
  void start();

  /// When this returns nothing is written any more.
  void stop();

  /// No tick until something else is ordered.
  void pause();
  Result<void> resume();

  /// Pauses and plays so many ticks at once, 1 .. kMostSteps, or up to the end; each of them is written.
  Result<void> step(std::int64_t ticks);

  Result<void> set_speed(double speed);

  /// Another game of the same teams, from its beginning or from a situation in the middle. Goes on unless it is paused.
  Result<void> reset(std::uint64_t seed);
  void reset(const sim::State& situation);

  /// How it goes. Never waits for a tick.
  foresight::Simulation state() const;

  const Setup& setup() const { return game_.setup(); }

 private:
  SimBody(Setup setup, SimOptions options, const SessionClock& clock);

  void run();
  void play_due_ticks();
  void tick();
  template <class From>
  void begin(const From& from);
  void begin_next();
  void show(std::uint64_t monotonic_ns);
  void show_state();
  void go_on();

  const SimOptions options_;
  const SessionClock& clock_;

  mutable Mutex lock_;  // guards all below
  Condition changed_;
  Game game_;
  Memories memories_;
  foresight::Simulation told_;  // what the object `simulation` tells
  Pacer pacer_;
  agent::Timeline timeline_;
  std::uint64_t wake_ns_ = 0;  // when the thread has something to do [monotonic]
  bool paused_ = false;
  bool running_ = false;
  std::thread thread_;
};

}  // namespace robot::body
