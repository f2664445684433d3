// The narrator: turns a simulated game, tick by tick, into the memory objects of all its robots.
#pragma once

#include <array>
#include <cstdint>
#include <memory>

#include "proto/foresight/sim.pb.h"
#include "robot/bridge/simulated_game.h"
#include "robot/bridge/to_messages.h"
#include "robot/core/clock.h"
#include "robot/core/result.h"
#include "robot/memory/channels.h"
#include "robot/memory/memory.h"
#include "sim/agent/beliefs.h"
#include "sim/math/tick.h"

namespace robot::bridge {

/// The pace of a simulation, beside the game itself.
struct Pacing {
  bool paused = false;
  double speed = 1;  // [game seconds per second]
  std::uint64_t ticks_behind = 0;
};

/// A memory for each robot of a game. The live simulated body and the recorder of `foresight-sim match --mcap` both use
/// it, so a recorded game holds exactly the objects of a live one. Used by one thread at a time.
class Narrator {
 public:
  /// Makes the memories of the robots of `game`. The memory of the robot with index `own` also gets the truth and the
  /// state of the simulation. `clock` outlives the narrator.
  Narrator(const SimulatedGame& game, int own, const Clock& clock);

  const std::shared_ptr<memory::Memory>& own() const { return memories_[static_cast<std::size_t>(own_)]; }

  /// Adds the simulated objects of each robot, the truth and the state of the simulation to `channels`.
  /// Returns an Error if a topic is taken.
  Result<void> list(memory::Channels& channels) const;

  /// Writes everything after a tick.
  ///
  /// The camera, its percepts, beliefs and decisions have the capture time of their image: the beginning of the tick. A robot
  /// far from the ball decides by several images at once; its percepts are written for each. Body and truth have the
  /// time of its end. So a belief and its truth have equal capture times. A robot beside the field gets no new beliefs.
  /// `game` and `team` are written on each change, and at least at 2 Hz and 1 Hz; `opponents` at 10 Hz.
  void write(const SimulatedGame& game, const Timeline& timeline);

  /// Writes the state of the simulation alone.
  void write_status(const SimulatedGame& game, const Pacing& pacing, const Timeline& timeline);

  /// Prepares for another game: the next write counts everything as changed.
  void forget() { written_ = sim::kNever; }

 private:
  /// The facts of a robot's last messages `game` and `team`.
  struct Told {
    sim::agent::Game game;
    std::array<sim::Tick, sim::agent::kMaxMates> mates{};  // send time of each
  };

  void write_image(const SimulatedGame& game, int robot, std::uint64_t capture_ns);
  void write_mind(const SimulatedGame& game, int robot, const Timeline& timeline, std::uint64_t capture_ns);
  void write_body(const SimulatedGame& game, int robot, std::uint64_t capture_ns);
  void write_game(const SimulatedGame& game, int robot, const Timeline& timeline);
  void write_team(const SimulatedGame& game, int robot, const Timeline& timeline);

  const int own_;
  std::array<std::shared_ptr<memory::Memory>, sim::kMaxRobots> memories_;  // null: no such robot
  std::array<Told, sim::kMaxRobots> told_;
  std::array<std::uint32_t, sim::kMaxRobots> packets_{};  // sent so far
  std::array<sim::Tick, sim::kMaxRobots> last_packet_;    // kNever: none of this game
  foresight::Simulation simulation_;
  sim::Tick written_ = sim::kNever;  // the last written tick; kNever: none of this game
  std::uint64_t written_ns_ = 0;     // its capture time
};

}  // namespace robot::bridge
