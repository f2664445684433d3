// A game with its past: key frames, from which any tick is played again.
//
// The law: a game that is played on from a key frame equals the first run in every tick, to the bit.
//
// Behaviours from outside have a memory of their own. Those that save it are set back with each key frame. With others the
// game is played again from its first tick.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "sim/debug/setup.h"
#include "sim/match/step.h"

namespace sim::debug {

/// The game so far, and its future. A copy shares the key frames, and has its own players from outside. Used by one
/// thread.
class Timeline {
 public:
  static constexpr std::size_t kMostBytes = 16'000'000;  // of the key frames of a game

  /// Begins with `start`. Keeps a state every few ticks. When the frames need more than `most_bytes`, every second one
  /// is dropped.
  Timeline(SharedSetup setup, const State& start, std::size_t most_bytes = kMostBytes);

  Tick first() const { return frames_.front()->state.world.tick; }
  /// Returns the latest tick that was played so far.
  Tick played() const { return played_; }
  /// Returns the state at a tick >= first(), before the tick is played. Plays on if nobody was there yet. Behind the end
  /// of the game it returns the last state.
  State at(Tick tick);
  /// Returns the setup by which that tick is played.
  const SharedSetup& setup_at(Tick tick) const;

  /// Returns the failure of a behaviour from outside as a sentence, or an empty text. The game is then wrong from there on.
  std::string problem() const;
  /// Returns whether all behaviours from outside save their memory. Without one it is true.
  bool saves() const { return saves_; }

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
  std::size_t bytes() const;
  /// Returns the distance of two key frames [ticks].
  Tick interval() const { return interval_; }

 private:
  /// A key frame, and the memory of the behaviours from outside.
  struct Frame {
    State state;
    std::string memory;
  };

  /// The behaviours from outside in the game of one timeline, at one tick. A copy has none, and begins its own.
  struct Players {
    Players() = default;
    Players(const Players&) {}
    Players& operator=(const Players& other) {
      if (this != &other) cast.reset();
      return *this;
    }

    std::unique_ptr<contest::Cast> cast;
    Params params;                // of `part`, with these behaviours
    const Setup* part = nullptr;  // of `params`
    State state;                  // to which their memory belongs
    std::string problem;          // loading failed
  };

  /// The setup from one tick to the next change.
  struct Part {
    Tick from;
    SharedSetup setup;
  };

  /// Plays one tick, and keeps a key frame if one is due. Behind an edit the state is the edited one.
  void advance(State& state, referee::Events& events);
  const Frame& frame_before(Tick tick) const;
  /// Returns the parameters of that tick, with the behaviours from outside.
  const Params& params_at(Tick tick);
  /// Begins the behaviours from outside anew, at the last moment before that tick to which they can be brought.
  void begin_players(Tick tick);
  void keep(const State& state);
  bool begins_part(Tick tick) const {
    return std::ranges::any_of(parts_, [&](const Part& part) { return part.from == tick; });
  }
  bool is_due(Tick tick) const { return (tick - first()) % interval_ == 0; }
  void thin_out();

  std::size_t most_bytes_;
  std::uint64_t seed_;  // of the first game, for the behaviours from outside
  Tick interval_ = 8;
  Tick played_;
  std::vector<std::shared_ptr<const Frame>> frames_;  // by tick; the first of each part is among them
  std::vector<Part> parts_;                           // by tick
  bool saves_ = true;
  Players players_;
};

}  // namespace sim::debug
