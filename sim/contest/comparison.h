// A comparison of two behaviours, against each other or each against a third, in games with the same luck.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "robot/core/result.h"
#include "sim/compare/pair_statistics.h"
#include "sim/contest/conditions.h"
#include "sim/contest/lineup.h"
#include "sim/contest/openings.h"
#include "sim/match/state.h"

namespace sim::contest {

/// The measure by which one behaviour is better.
enum class Metric {
  goals,         // the difference of goals
  first_goal,    // the first goal: 1, -1, or 0 without one; the game ends with it
  conceded,      // fewer goals against; only with a third behaviour
  score_within,  // an own goal within the given time
  ball_advance,  // gain of the ball's place towards the opponents' goal line after the given time; a goal ends the game
};
const char* name_of(Metric metric);
/// Returns the number of smallest units in one unit of the metric: advances are counted in centimetres.
constexpr double unit_of(Metric metric) { return metric == Metric::ball_advance ? 100 : 1; }

struct ComparisonChoice {
  std::string a, b;
  std::string opponent;  // both play against it; empty: they play against each other
  std::string rules = "spl2012", models = "match";
  int players = 0;  // a side; 0: as in the rules
  int changed = 0;  // B's players 1 .. `changed` play B, the others A; 0: all play B
  Pace pace = Pace::thinned;
  std::string situation;  // the start of the games (Openings)
  bool fuzz = false;
  double seconds = 0;  // longest time of a game [s]; 0: to its end
  Metric metric = Metric::goals;
  std::uint64_t seed = 1;  // of the first pair
  bool unpaired = false;   // the second game of a pair has other luck: a test of the two ends of the field
  Conditions conditions;
};

/// A pair and the cost of its decisions.
struct PlayedPair {
  compare::Pair pair;
  DecisionCost cost[2];  // of A, of B
};

/// The games of a comparison. Any thread may play any pair.
class Comparison {
 public:
  static robot::Result<Comparison> prepare(const ComparisonChoice& choice);

  const ComparisonChoice& choice() const { return choice_; }
  double unit() const { return unit_of(choice_.metric); }

  /// Plays pair `number`, always with the same result. Returns an Error if a behaviour from outside does not answer.
  robot::Result<PlayedPair> play(std::int64_t number) const;

  /// Returns the seed of a pair's games.
  std::uint64_t seed_of(std::int64_t number) const { return choice_.seed + static_cast<std::uint64_t>(number); }

  /// Returns the identity of the run as one line of JSON: the choice, hashes of the files, and a hash of a game with these
  /// behaviours on this build.
  const std::string& specification() const { return specification_; }

 private:
  /// A game between two behaviours, and the side of the judged one.
  struct Seat {
    Lineup lineup;
    Side side;
    Openings openings;
  };

  struct Score {
    int own = 0, other = 0;  // goals
    int value = 0;           // [smallest units] of the metric
    DecisionCost cost[2];    // of the judged side, of the other
  };

  robot::Result<Score> play(const Seat& seat, std::uint64_t seed) const;
  robot::Result<void> seat(std::vector<Seat>& seats, const std::string& judged, const std::string& against, Side side,
                           bool changed);
  robot::Result<std::string> probe() const;

  ComparisonChoice choice_;
  std::vector<Seat> a_, b_;  // by the game's place in the pair
  std::string specification_;
};

}  // namespace sim::contest
