// Many games of one lineup: on all processors, and those of trees side by side.
#pragma once

#include <algorithm>
#include <cstdint>
#include <functional>
#include <memory>
#include <type_traits>
#include <utility>
#include <vector>

#include "robot/core/result.h"
#include "sim/contest/lineup.h"
#include "sim/contest/series.h"
#include "sim/match/play.h"

namespace sim::contest {

/// The numbers of a series of games. Game i has the seed `first_seed` + i.
struct Series {
  std::uint64_t first_seed = 0;
  int games = 0;
  int threads = 0;         // 0: threads_for(games)
  Costs* costs = nullptr;  // receives the cost of all decisions, if given
};

/// Returns the number of consecutive games that share a cast. It is 1 if a side plays a behaviour from outside. Otherwise
/// it is at most twice kTogether, and each thread plays at least two such parts if there are enough games.
int games_of_a_cast(const Lineup& lineup, const Series& series);

/// Plays all games. begin(i, seed, cast) returns a std::unique_ptr of game i before its first step: a Game as play_many
/// has it. end(i, game, cast) receives it after its last step. Several threads call both.
///
/// Calls `progress` from the calling thread with the number of games so far. Returns the failure of a behaviour from
/// outside, which ends its game at once; no further game is begun after it.
template <class Begin, class End>
robot::Result<void> play_series(const Lineup& lineup, const Series& series, Begin&& begin, End&& end,
                                const std::function<void(int)>& progress = {}) {
  using Game = typename std::invoke_result_t<Begin, int, std::uint64_t, const Cast&>::element_type;
  struct Playing {
    int number;
    const Cast* cast;
    std::unique_ptr<Game> game;
    State& state = game->state;

    bool goes_on() { return !cast->failed() && game->goes_on(); }
    void see(const referee::Events& events) { game->see(events); }
  };

  Problem problem;
  const int part = games_of_a_cast(lineup, series), parts = (series.games + part - 1) / part;
  const auto seed_of = [&](int number) { return series.first_seed + static_cast<std::uint64_t>(number); };
  for_each_game(
      parts, series.threads > 0 ? series.threads : threads_for(parts),
      [&](int index) {
        if (problem.is_known()) return;
        const int from = index * part, to = std::min(from + part, series.games);
        const Cast cast(lineup, seed_of(from));
        std::vector<Playing> playing;
        playing.reserve(static_cast<std::size_t>(to - from));  // a game stays where it is
        int begun = from;
        play_many<Playing>(cast.params(), kTogether, [&](Playing* ended) -> Playing* {
          if (ended) {
            end(ended->number, *ended->game, cast);
            ended->game.reset();
          }
          if (begun == to) return nullptr;
          const int number = begun++;
          playing.push_back({number, &cast, begin(number, seed_of(number), cast)});
          return &playing.back();
        });
        if (cast.failed()) problem.tell(cast.problem());
        if (series.costs) series.costs->add(cast);
      },
      [&](int finished) {
        if (progress) progress(std::min(series.games, finished * part));
      });
  if (problem.is_known()) return robot::Error{problem.text()};
  return {};
}

}  // namespace sim::contest
