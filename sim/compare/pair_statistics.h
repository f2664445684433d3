// What pairs of games came to, in whole numbers: sums of any order are the same to the bit, and need no memory.
#pragma once

#include <cstdint>

namespace sim::compare {

/// Behaviours A and B.
inline constexpr int kA = 0, kB = 1;

/// One game of a pair. Against each other A and B are in the same game; against a third one they are in two games of the
/// same seed and the same end of the field, which count as one here.
struct GameResult {
  int gain = 0;           // what B did better than A by the metric that is compared, in its smallest unit
  int goals[2] = {0, 0};  // scored by A, by B
  int conceded[2] = {0, 0};

  friend bool operator==(const GameResult&, const GameResult&) = default;
};

/// Two games with the same luck and the ends swapped: whatever favours an end favours both behaviours once.
struct Pair {
  GameResult games[2];  // B is the away team in the first, the home team in the second

  friend bool operator==(const Pair&, const Pair&) = default;
};

/// All sums of some pairs. Sums of up to 10^12 pairs fit.
struct PairStatistics {
  std::int64_t pairs = 0;
  std::int64_t gain = 0, gain_squares = 0;                            // of a pair: the sum of its two games
  std::int64_t game_gain[2] = {0, 0}, game_gain_squares[2] = {0, 0};  // by the game's place in the pair
  std::int64_t goals[2] = {0, 0}, conceded[2] = {0, 0};               // by behaviour
  std::int64_t won = 0, drawn = 0, lost = 0;                          // games, as B sees them
  std::int64_t points[5] = {0, 0, 0, 0, 0};  // pairs in which B got 0 .. 4 points: 2 of a game won, 1 of one drawn

  void add(const Pair& pair);
  void add(const PairStatistics& other);

  friend bool operator==(const PairStatistics&, const PairStatistics&) = default;
};

}  // namespace sim::compare
