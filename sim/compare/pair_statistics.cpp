#include "sim/compare/pair_statistics.h"

#include <initializer_list>

namespace sim::compare {

void PairStatistics::add(const Pair& pair) {
  ++pairs;
  std::int64_t sum = 0;
  int got = 2;
  for (const int place : {0, 1}) {
    const GameResult& game = pair.games[place];
    sum += game.gain;
    if (game.gain != 0) ++eventful_games;
    game_gain[place] += game.gain;
    game_gain_squares[place] += std::int64_t{game.gain} * game.gain;
    for (const int behaviour : {kA, kB}) {
      goals[behaviour] += game.goals[behaviour];
      conceded[behaviour] += game.conceded[behaviour];
    }
    const int lead = game.goals[kB] - game.conceded[kB] - (game.goals[kA] - game.conceded[kA]);
    ++(lead > 0 ? won : lead < 0 ? lost : drawn);
    got += lead > 0 ? 1 : lead < 0 ? -1 : 0;
  }
  ++points[got];
  gain += sum;
  gain_squares += sum * sum;
  if (sum != 0) ++uneven;
  if (pair.same) ++same;
}

void PairStatistics::add(const PairStatistics& other) {
  pairs += other.pairs;
  gain += other.gain;
  gain_squares += other.gain_squares;
  for (const int i : {0, 1}) {
    game_gain[i] += other.game_gain[i];
    game_gain_squares[i] += other.game_gain_squares[i];
    goals[i] += other.goals[i];
    conceded[i] += other.conceded[i];
  }
  won += other.won;
  drawn += other.drawn;
  lost += other.lost;
  for (int i = 0; i < 5; ++i) points[i] += other.points[i];
  same += other.same;
  uneven += other.uneven;
  eventful_games += other.eventful_games;
}

}  // namespace sim::compare
