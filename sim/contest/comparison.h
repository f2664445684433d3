// What is compared: two behaviours, against each other or each against a third, in games of the same luck.
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

/// By what one is better than the other.
enum class Metric {
  goals,         // the difference of goals
  first_goal,    // who scores first: 1, -1, or 0 where nobody does; a game ends with it
  conceded,      // fewer goals of the others; only against a third behaviour
  score_within,  // a goal of one's own within the given time
  ball_advance,  // how much nearer to the opponents' goal line the ball is after the given time; a goal ends it
};
const char* name_of(Metric metric);
/// How many of its smallest units make one: advances are counted in centimetres.
constexpr double unit_of(Metric metric) { return metric == Metric::ball_advance ? 100 : 1; }

struct ComparisonChoice {
  std::string a, b;
  std::string opponent;  // both play against this one; empty: against each other
  std::string rules = "spl2012", models = "match";
  int players = 0;  // a side; 0: as the rules say
  int changed = 0;  // B's players 1 .. so many play B, its others A; 0: all of them play B
  Pace pace = Pace::thinned;
  std::string situation;  // where games begin (Openings)
  bool fuzz = false;
  double seconds = 0;  // how long a game goes on at most [s]; 0: to its end
  Metric metric = Metric::goals;
  std::uint64_t seed = 1;  // of the first pair
  bool unpaired = false;   // the second game of a pair has another luck: for testing the ends of the field
  Conditions conditions;
};

/// A pair, and what the decisions in it cost.
struct PlayedPair {
  compare::Pair pair;
  DecisionCost cost[2];  // of A, of B
};

/// Any thread plays any pair.
class Comparison {
 public:
  static robot::Result<Comparison> prepare(const ComparisonChoice& choice);

  const ComparisonChoice& choice() const { return choice_; }
  double unit() const { return unit_of(choice_.metric); }

  /// Plays pair `number`: always the same. An Error if a behaviour from outside does not answer.
  robot::Result<PlayedPair> play(std::int64_t number) const;

  /// The seed of a pair's games.
  std::uint64_t seed_of(std::int64_t number) const { return choice_.seed + static_cast<std::uint64_t>(number); }

  /// What everything follows from, as one line of JSON: the choice, the contents of files, and a hash of how a game with
  /// these behaviours goes on this build.
  const std::string& specification() const { return specification_; }

 private:
  /// A game between two: the sides of the one that is judged.
  struct Seat {
    Lineup lineup;
    Side side;
    Openings openings;
  };

  struct Score {
    int own = 0, other = 0;  // goals
    int value = 0;           // by the metric
    DecisionCost cost[2];    // of the judged side, of the other
  };

  robot::Result<Score> play(const Seat& seat, std::uint64_t seed) const;
  robot::Result<void> seat(std::vector<Seat>& seats, const std::string& judged, const std::string& against, Side side,
                           bool changed);
  robot::Result<std::string> probe() const;

  ComparisonChoice choice_;
  std::vector<Seat> a_, b_;  // by the place of the game in the pair
  std::string specification_;
};

}  // namespace sim::contest
