// A comparison of two behaviours: against each other, or each against a third, in games with the same seeds.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "robot/core/result.h"
#include "sim/compare/pair_statistics.h"
#include "sim/contest/conditions.h"
#include "sim/contest/lineup.h"
#include "sim/contest/openings.h"
#include "sim/match/state.h"

namespace sim::contest {

/// The measure by which one behaviour is better than the other.
enum class Metric {
  goals,         // the difference of goals
  first_goal,    // the first goal: 1 own, -1 of the other, 0 none; it ends the game
  conceded,      // fewer goals against; only with a third behaviour
  score_within,  // an own goal scored within the given time
  ball_advance,  // way of the ball towards the opponents' goal line in the given time; a goal ends the game
};
const char* name_of(Metric metric);
/// Returns the number of the metric's smallest units in one: advances are counted in centimetres.
constexpr double unit_of(Metric metric) { return metric == Metric::ball_advance ? 100 : 1; }

struct ComparisonChoice {
  std::string a, b;
  std::string opponent;  // A and B play against this one; empty: against each other
  std::string rules = "spl2012", models = "match";
  int players = 0;  // per side; 0: by the rules
  int changed = 0;  // B's players 1 .. `changed` play B, its others A; 0: all play B
  Pace pace = Pace::thinned;
  std::string situation;  // start of the games (Openings)
  bool fuzz = false;
  double seconds = 0;  // [s] longest game; 0: to its end
  Metric metric = Metric::goals;
  std::uint64_t seed = 1;  // of the first pair
  // the second game of a pair has another seed, and the sides exchange the situation: tests the ends of the field
  bool unpaired = false;
  Conditions conditions;
};

/// Pairs in a row, and the cost of the decisions in them.
struct PlayedPairs {
  std::vector<compare::Pair> pairs;
  DecisionCost cost[2];  // of A, of B
};

/// A prepared comparison. Thread-safe: any thread can play any pair.
class Comparison {
 public:
  static robot::Result<Comparison> prepare(const ComparisonChoice& choice);

  const ComparisonChoice& choice() const { return choice_; }
  double unit() const { return unit_of(choice_.metric); }

  /// Plays `count` pairs from pair `first` on, their games side by side. The result of a pair is always the same. Returns
  /// an Error if a behaviour from outside does not answer.
  robot::Result<PlayedPairs> play(std::int64_t first, std::int64_t count) const;

  /// Returns the seed of a pair's games.
  std::uint64_t seed_of(std::int64_t number) const { return choice_.seed + static_cast<std::uint64_t>(number); }

  /// The lineup and the start of the game of a pair in which B is at home.
  const Lineup& lineup_of_b() const { return b_.back().lineup; }
  const Openings& openings_of_b() const { return b_.back().openings; }

  /// The facts that determine every result, as one line of JSON: the choice, hashes of the files' contents, and a hash
  /// of games that these behaviours play on this build.
  const std::string& specification() const { return specification_; }

 private:
  /// One game of a pair: its players, and the side of the behaviour that is judged.
  struct Seat {
    Lineup lineup;
    Side side;
    Openings openings;
  };

  struct Score {
    int own = 0, other = 0;  // goals
    int value = 0;           // by the metric
    std::uint64_t hash = 0;  // of all that happened
  };
  /// The scores of games by their start, and the cost of decisions of the judged side and of the other side.
  struct Scores {
    std::vector<Score> games;
    DecisionCost cost[2];
  };
  class Game;

  robot::Result<Scores> play(const Seat& seat, std::span<const Start> starts) const;
  compare::Pair pair_of(const Scores (&a)[2], const Scores (&b)[2], std::size_t number) const;
  Start start_of(std::int64_t number, int place) const;
  robot::Result<void> seat(std::vector<Seat>& seats, const std::string& judged, const std::string& against, Side side,
                           bool changed);
  robot::Result<std::string> probe() const;

  ComparisonChoice choice_;
  std::vector<Seat> a_, b_;  // by the game's place in the pair; B is at home in the last one
  std::string specification_;
};

}  // namespace sim::contest
