// A game with its past: key frames, from which any tick is played again.
//
// The law: a game that is played on from a key frame equals the first run in every tick, to the bit.
#pragma once

#include <cstddef>
#include <memory>
#include <vector>

#include "sim/debug/setup.h"
#include "sim/match/step.h"

namespace sim::debug {

/// The game so far, and its future. A copy shares the key frames. Used by one thread.
class Timeline {
 public:
  static constexpr std::size_t kMostBytes = 16'000'000;  // of the key frames of a game

  /// Begins with `start`. Keeps a state every few ticks. When the frames need more than `most_bytes`, every second one
  /// is dropped.
  Timeline(SharedSetup setup, const State& start, std::size_t most_bytes = kMostBytes);

  Tick first() const { return frames_.front()->world.tick; }
  /// Returns the latest tick that was played so far.
  Tick played() const { return played_; }
  /// Returns the state at a tick >= first(), before the tick is played. Plays on if nobody was there yet. Behind the end
  /// of the game it returns the last state.
  State at(Tick tick);
  /// Returns the setup by which that tick is played.
  const SharedSetup& setup_at(Tick tick) const;

  /// Changes the game from the tick of `state` on: `state` replaces the state there, and `setup` is played from there.
  /// The future is forgotten. The tick must have been played.
  void change(const State& state, SharedSetup setup);

  /// Plays the ticks from .. to - 1 and calls see(before, after, events) for each. Ends when `see` returns false or the
  /// game is over. Returns the last state.
  template <class See>
  State replay(Tick from, Tick to, See&& see) {
    State state = at(from);
    referee::Events events;
    while (state.world.tick < to && !finished(state)) {
      const State before = state;
      advance(state, events);
      if (!see(before, state, events)) break;
    }
    return state;
  }

  /// Returns the ticks with key frames, ascending.
  std::vector<Tick> key_frames() const;
  /// Returns the memory of all key frames [bytes].
  std::size_t bytes() const { return frames_.size() * sizeof(State); }
  /// Returns the distance of two key frames [ticks].
  Tick interval() const { return interval_; }

 private:
  /// The setup from one tick to the next change.
  struct Part {
    Tick from;
    SharedSetup setup;
  };

  /// Plays one tick, and keeps a key frame if one is due.
  void advance(State& state, referee::Events& events);
  bool is_due(Tick tick) const { return (tick - first()) % interval_ == 0; }
  void thin_out();

  std::size_t most_bytes_;
  Tick interval_ = 8;
  Tick played_;
  std::vector<std::shared_ptr<const State>> frames_;  // by tick; the first of each part is among them
  std::vector<Part> parts_;                           // by tick
};

}  // namespace sim::debug
