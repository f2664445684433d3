// Whole games and their results.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <span>
#include <vector>

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
    for (const referee::Event& event : events) on_event(event);
  }
  return state.world.tick - began;
}

/// Plays games with the same parameters side by side, at most kMostGames at once. With 16 of them a game takes 0.7
/// times as long as alone. Each game has the same bits as alone.
///
/// next(ended) returns the next game to play, or nullptr when there is no other. `ended` is the game that leaves its place
/// to the next, or nullptr; its memory may be used again. A Game has the members `State state`, `bool goes_on()`, called
/// before each step, and `void see(events)`, called after each step with the referee's decisions. A finished game is not
/// asked whether it goes on.
template <class Game, class Next>
void play_many(const Params& params, std::size_t together, Next&& next) {
  std::array<Game*, kMostGames> games;
  std::array<State*, kMostGames> states;
  std::array<referee::Events, kMostGames> events;
  std::size_t count = 0;
  const auto goes_on = [](Game& game) { return !finished(game.state) && game.goes_on(); };
  // Puts the next game that has a tick to play at a place. Returns false when there is none.
  const auto fill = [&](std::size_t place, Game* ended) {
    while (Game* const game = next(ended)) {
      games[place] = game;
      states[place] = &game->state;
      if (goes_on(*game)) return true;
      ended = game;
    }
    return false;
  };

  together = std::clamp(together, std::size_t{1}, kMostGames);
  while (count < together && fill(count, nullptr)) ++count;
  while (count > 0) {
    step_many(params, {states.data(), count}, {events.data(), count});
    for (std::size_t i = 0; i < count; ++i) games[i]->see(events[i]);
    for (std::size_t i = 0; i < count;) {
      if (goes_on(*games[i]) || fill(i, games[i])) {
        ++i;
      } else {
        games[i] = games[--count];
        states[i] = states[count];
      }
    }
  }
}

/// Plays on to the end of the game, for at most `most` ticks. The result counts the events of this part only.
Result play_on(const Params& params, State& state, Tick most = kNever);

/// Plays several games on, side by side, each for at most `most` ticks.
void play_on(const Params& params, std::span<State> games, Tick most);

/// Plays a whole game.
Result play_game(const Params& params, RandomKey key);

/// Plays whole games side by side. Returns their results in the order of the keys.
std::vector<Result> play_games(const Params& params, std::span<const RandomKey> keys);

}  // namespace sim
