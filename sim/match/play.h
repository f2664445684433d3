// Whole games and their results.
#pragma once

#include "sim/match/step.h"

namespace sim {

inline constexpr int kEventKinds = static_cast<int>(referee::Event::Kind::placed) + 1;

using agent::kSetPlays;

/// The result of a game or of a part of one. Pairs are by Side.
struct Result {
  std::uint8_t score[2];
  referee::GameCounts counts;
  Tick ticks;                            // since the start of the game, dead time included
  bool over;                             // the game has ended
  float walked[2];                       // [m] by all robots of a side
  std::int32_t packets[2];               // sent
  std::uint32_t events[kEventKinds][2];  // number of events, by referee::Event::Kind and Event::side
  // set plays by agent::Game::SetPlay and the kicking side; 0 is unused
  std::uint32_t taken[kSetPlays][2];    // ended by the first touch of the kicking side
  std::uint32_t expired[kSetPlays][2];  // ended because their time was up

  void count(const referee::Event& event);

  /// Returns the share of possession [0..1]: the time in play in which this side was the last to touch the ball. It is
  /// 0 when nobody had the ball.
  float possession(Side side) const;
};

/// Returns the result so far. A State does not keep its events, so `decided` must have counted them.
Result result_of(const State& state, const Result& decided = {});

/// Steps until the game is over or `until(state)` returns true; it is called before each step. Calls on_event(event)
/// for each decision of the referee, in order. Returns the number of ticks played.
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

/// Plays on to the end of the game, for at most `most` ticks. The result counts the events of this part only.
Result play_on(const Params& params, State& state, Tick most = kNever);

/// Plays a whole game.
Result play_game(const Params& params, RandomKey key);

}  // namespace sim
