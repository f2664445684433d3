// The results of pairs of games as sums of whole numbers: equal in any order, without a list of games.
#pragma once

#include <cstdint>

namespace sim::compare {

/// Behaviours A and B.
inline constexpr int kA = 0, kB = 1;

/// One game of a pair. A and B play it against each other. With a third behaviour it stands for two games with the same
/// seed and the same end of the field: one of A and one of B.
struct GameResult {
  int gain = 0;           // advantage of B over A in the compared metric, in its smallest unit
  int goals[2] = {0, 0};  // scored by A, by B
  int conceded[2] = {0, 0};

  friend bool operator==(const GameResult&, const GameResult&) = default;
};

/// Two games with the same luck and the ends swapped: an advantage of an end helps each behaviour once.
struct Pair {
  GameResult games[2];     // B is the away team in the first, the home team in the second
  bool same = false;       // B played what A played: the games of both are the same games, with A and B exchanged
  std::uint64_t hash = 0;  // of all that happened in its games; pairs with equal hashes are the same pair

  friend bool operator==(const Pair&, const Pair&) = default;
};

/// Sums over pairs. Up to 10^12 pairs fit.
struct PairStatistics {
  std::int64_t pairs = 0;
  std::int64_t gain = 0, gain_squares = 0;                            // of a pair: sum of its two games
  std::int64_t game_gain[2] = {0, 0}, game_gain_squares[2] = {0, 0};  // by the game's place in the pair
  std::int64_t goals[2] = {0, 0}, conceded[2] = {0, 0};               // by behaviour
  std::int64_t won = 0, drawn = 0, lost = 0;                          // games, from B's side
  std::int64_t points[5] = {0, 0, 0, 0, 0};  // pairs by B's points 0 .. 4: 2 for a win, 1 for a draw
  std::int64_t same = 0;                     // pairs in which B played what A played
  std::int64_t uneven = 0;                   // pairs whose gain is not 0
  std::int64_t eventful_games = 0;           // games whose gain is not 0

  void add(const Pair& pair);
  void add(const PairStatistics& other);

  friend bool operator==(const PairStatistics&, const PairStatistics&) = default;
};

}  // namespace sim::compare
