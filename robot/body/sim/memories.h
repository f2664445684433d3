// The memories of all robots of a simulated game.
#pragma once

#include <array>
#include <cstdint>
#include <memory>

#include "proto/foresight/sim.pb.h"
#include "robot/agent/convert.h"
#include "robot/body/sim/game.h"
#include "robot/core/clock.h"
#include "robot/core/result.h"
#include "robot/memory/channels.h"
#include "robot/memory/memory.h"
#include "sim/agent/beliefs.h"
#include "sim/math/tick.h"

namespace robot::body {

/// Each robot of the game has a memory under its own name; one of them is this process's own, which also tells what is
/// true and how the simulation goes. Used by one thread at a time.
class Memories {
 public:
  /// `own` is the index of the robot that this process is; `clock` outlives the memories.
  Memories(const Setup& setup, int own, const Clock& clock);

  const std::shared_ptr<memory::Memory>& own() const { return memories_[static_cast<std::size_t>(own_)]; }

  /// Lists what is simulated of each robot, the truth and the state of the simulation; what this process tells of itself
  /// (`runtime`, `clock`, `log`) too. An Error if a topic is taken.
  Result<void> list(memory::Channels& channels) const;

  /// Everything after a tick. What a robot believes and decided has the capture time of the image that it comes from:
  /// the beginning of the tick; what its body does and what is true has that of the end. So at equal capture times
  /// stand a belief and its truth. A robot beside the field believes nothing new.
  /// `game` and `team` are written when they change, and at least 2 Hz, 1 Hz.
  void write(const Game& game, const agent::Timeline& timeline);

  /// Another game begins: everything counts as changed.
  void forget() { written_ = sim::kNever; }

 private:
  /// What a robot was told last.
  struct Told {
    sim::agent::Game game;
    std::array<sim::Tick, sim::agent::kMaxMates> mates{};  // when each had sent
  };

  void write_mind(const Game& game, int robot, const agent::Timeline& timeline, std::uint64_t capture_ns);
  void write_body(const Game& game, int robot, std::uint64_t capture_ns);
  void write_game(const Game& game, int robot, const agent::Timeline& timeline);
  void write_team(const Game& game, int robot, const agent::Timeline& timeline);

  const int own_;
  std::array<std::shared_ptr<memory::Memory>, sim::kMaxRobots> memories_;  // null: no such robot
  std::array<Told, sim::kMaxRobots> told_;
  sim::Tick written_ = sim::kNever;  // the last tick that was; kNever: none of this game
  std::uint64_t written_ns_ = 0;     // its capture time
};

/// What does not change during a run: rules, teams, field.
foresight::Simulation describe(const Setup& setup);

}  // namespace robot::body
