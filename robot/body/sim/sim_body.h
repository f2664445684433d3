// The body of a simulated game, with all its robots. One of them is this process's own.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <thread>

#include "proto/foresight/sim.pb.h"
#include "robot/body/sim/pacer.h"
#include "robot/bridge/game_past.h"
#include "robot/bridge/narrator.h"
#include "robot/bridge/simulated_game.h"
#include "robot/core/clock.h"
#include "robot/core/lock.h"
#include "robot/core/result.h"
#include "robot/memory/channels.h"
#include "robot/memory/memory.h"
#include "sim/io/matchup.h"

namespace robot::body {

/// The teams and rules of all games of one run.
struct GameSetup {
  sim::io::PreparedGame game;
  bridge::GameNames names;

  const sim::Params& params() const { return game.params; }
};

struct SimOptions {
  int robot = 1;           // index of this process's own robot
  std::uint64_t seed = 1;  // of the first game, 0 .. SimBody::kGreatestSeed
  double speed = 1;        // [game seconds per second] Pacer::kSlowest .. kFastest
  bool loop = false;       // another game, of the next seed, follows `rest_ns` after the end
  std::uint64_t rest_ns = 5 * kSecond;
};

/// The body that plays a simulated game in a thread of its own and writes every robot's memory. An order is carried
/// out, and visible in memory, when its call returns. Any thread.
class SimBody {
 public:
  static constexpr std::uint64_t kGreatestSeed = (std::uint64_t{1} << 53) - 1;  // a number that JSON keeps exact
  static constexpr std::int64_t kMostSteps = 1800;                              // a minute at once

  /// Opens the body at the beginning of the first game. `clock` outlives the body. Returns an
  /// Error if an option is out of range.
  static Result<std::unique_ptr<SimBody>> open(GameSetup setup, SimOptions options, const SessionClock& clock);

  /// Calls stop().
  ~SimBody();

  /// Returns the memory of this process's own robot.
  const std::shared_ptr<memory::Memory>& memory() const { return narrator_.own(); }

  /// Adds the objects of all simulated robots to `channels`, and this process's own: clock, statistics, log, foresight.
  Result<void> list(memory::Channels& channels) const;

  /// Starts the game. Called once. Returns an Error if the system allows no more threads.
  Result<void> start();

  /// Ends the thread. Nothing is written after the return.
  void stop();

  /// Stops the game until the next order.
  void pause();
  Result<void> resume();

  /// Pauses and plays `ticks` at once, 1 .. kMostSteps, or up to the end of the game. Each tick is written.
  Result<void> step(std::int64_t ticks);

  /// Pauses and returns the game to the tick `ticks` before, at most to its beginning. The same future follows, to the
  /// bit, as long as the captain chooses the same. Returns an Error if `ticks` is not 1 .. kMostBack.
  Result<void> back(std::int64_t ticks);
  static constexpr std::int64_t kMostBack = 1'000'000;

  Result<void> set_speed(double speed);

  /// Returns the present game at one of its ticks, by default now. Returns an Error if the game of `seed` is no longer
  /// played, or for a tick that it has not reached or no longer keeps.
  Result<sim::State> state_at(std::optional<std::uint64_t> seed, std::optional<sim::Tick> tick) const;

  /// Pauses and replaces the state of the present moment. `state` is of the present tick. The past stays, and going back
  /// and forward again beyond this moment undoes the edit. Returns an Error if the game has moved on, or has been edited
  /// too often.
  Result<void> edit(const sim::State& state);

  /// Starts another game of the same teams, from its beginning or from a situation. It runs unless paused.
  Result<void> reset(std::uint64_t seed);
  void reset(const sim::State& situation);

  /// Returns the state of the simulation. Never waits for a tick.
  foresight::Simulation state() const;

  const GameSetup& setup() const { return setup_; }

 private:
  SimBody(GameSetup setup, SimOptions options, const SessionClock& clock);

  void run();
  void play_due_ticks();
  void tick();
  void begin(const sim::State& state);
  void begin_next();
  void show(std::uint64_t monotonic_ns);
  void show_status();
  void go_on();

  const GameSetup setup_;
  const SimOptions options_;
  const SessionClock& clock_;

  mutable Mutex lock_;  // guards all below
  Condition changed_;
  bridge::SimulatedGame game_;
  bridge::GamePast past_;
  bridge::Narrator narrator_;
  Pacer pacer_;
  bridge::Timeline timeline_;
  std::uint64_t wake_ns_ = 0;  // [monotonic] time of the thread's next work
  bool paused_ = false;
  bool running_ = false;
  std::thread thread_;
};

}  // namespace robot::body
