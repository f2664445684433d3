// The past of a simulated game: any tick of it again, equal to the bit.
#pragma once

#include <cstddef>
#include <vector>

#include "robot/bridge/simulated_game.h"

namespace robot::bridge {

/// Key frames of a game, the choices of its captain between them, and the edits of people. The memory is taken at once and stays the same.
/// Used by one thread at a time.
class GamePast {
 public:
  static constexpr std::size_t kFrames = 500;  // 4 MB
  static constexpr std::size_t kEdits = 50;

  GamePast();

  /// Forgets everything, and keeps the beginning: the present moment of `game`.
  void begin(const SimulatedGame& game);

  /// Keeps what the next tick begins with: a key frame if one is due, and the strategy that `robot` follows. Called
  /// before each tick. The ticks behind this one belong to another future, and are forgotten.
  void note(const SimulatedGame& game);
  void note_choice(sim::Tick tick, int robot, const sim::agent::Choice& choice);

  /// Keeps the edited present moment. Returns false if there are kEdits already.
  bool note_edit(const SimulatedGame::Moment& edited);

  sim::Tick first() const { return frames_[0].state.world.tick; }

  /// Returns the game to a tick from first() to its present one, with the edits up to there. It plays on from a key frame
  /// before, so the decisions of the last tick are known, except at first().
  void go_to(sim::Tick tick, SimulatedGame& game) const;

 private:
  /// A choice of the captain. It holds until the next one.
  struct Followed {
    sim::Tick tick;
    int robot;
    sim::agent::Choice choice;
  };

  sim::Tick interval_ = 0;  // [ticks] between two frames; doubles when the frames do not suffice
  std::size_t count_ = 0;   // frames in use
  std::vector<SimulatedGame::Moment> frames_;
  std::vector<SimulatedGame::Moment> edits_;  // by tick
  std::vector<Followed> choices_;             // by tick, each different from the one before
};

}  // namespace robot::bridge
