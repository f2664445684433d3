// Whole games, and what they came to.
#pragma once

#include "sim/match/step.h"

namespace sim {

inline constexpr int kEventKinds = static_cast<int>(referee::Event::Kind::placed) + 1;

/// What a game, or a part of one, came to. Pairs are by Side.
struct Result {
  std::uint8_t score[2];
  referee::GameCounts counts;
  Tick ticks;                            // from its beginning, dead time included
  bool over;                             // the game came to its end
  float walked[2];                       // [m] by all robots of a side
  std::int32_t packets[2];               // sent
  std::uint32_t events[kEventKinds][2];  // by referee::Event::Kind and the side each was about

  /// Share of the time in play since whose touch it was; 0 when the ball was never in play.
  float possession(Side side) const;
};

/// What the game has come to so far. A state does not keep its events: `events` are all 0.
Result result_of(const State& state);

/// Steps until the game is over or `until(state)` says to stop, which is asked before each step. on_event(event) hears
/// every decision of the referee in its order. Returns how many ticks it was.
template <class Until, class OnEvent>
Tick play(const Params& params, State& state, Until&& until, OnEvent&& on_event) {
  const Tick began = state.world.tick;
  referee::Events events;
  while (!finished(state) && !until(state)) {
    step(params, state, events);
    for (int i = 0; i < events.count; ++i) on_event(events.list[static_cast<std::size_t>(i)]);
  }
  return state.world.tick - began;
}

/// Plays on to the end of the game, at most `most` ticks. The events are those of this part.
Result play_on(const Params& params, State& state, Tick most = kNever);

/// A whole game.
Result play_game(const Params& params, RandomKey key);

}  // namespace sim
