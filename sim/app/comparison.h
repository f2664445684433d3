// What is compared: two behaviours, against each other or each against a third, in games of the same luck.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "robot/core/result.h"
#include "sim/compare/tally.h"
#include "sim/io/setup.h"
#include "sim/match/state.h"

namespace sim::app {

/// By what one is better than the other.
enum class Metric {
  goals,         // the difference of goals
  first_goal,    // who scores first: 1, -1, or 0 where nobody does; a game ends with it
  conceded,      // fewer goals of the others; only against a third behaviour
  score_within,  // a goal of one's own within the given time
};

struct ComparisonChoice {
  std::string a = "baseline", b;
  std::string opponent;  // both play against this one; empty: against each other
  std::string rules = "spl2012", models = "match";
  int players = 0;  // a side; 0: as the rules say
  Pace pace = Pace::thinned;
  std::string situation;  // path of a described moment where games begin; empty: the kick-off
  double seconds = 0;     // how long a game goes on at most [s]; 0: to its end
  Metric metric = Metric::goals;
  std::uint64_t seed = 1;  // of the first pair
};

/// Any thread plays any pair.
class Comparison {
 public:
  static robot::Result<Comparison> prepare(const ComparisonChoice& choice);

  const ComparisonChoice& choice() const { return choice_; }

  /// Plays pair `number`: always the same.
  compare::Pair play(std::int64_t number) const;

  /// The seed of a pair's games.
  std::uint64_t seed_of(std::int64_t number) const { return choice_.seed + static_cast<std::uint64_t>(number); }

  /// What everything follows from, as one line of JSON: the choice, the contents of files, and a hash of how a game with
  /// these behaviours goes on this build.
  const std::string& specification() const { return specification_; }

 private:
  /// A game between two: the sides of the one that is judged.
  struct Seat {
    Params params;
    Side side;
    std::optional<State> start;  // of a situation
  };

  struct Score {
    int own = 0, other = 0;  // goals
    int value = 0;           // by the metric
  };

  Score play(const Seat& seat, std::uint64_t seed) const;
  robot::Result<void> seat(std::vector<Seat>& seats, const std::string& home, const std::string& away, Side judged);

  ComparisonChoice choice_;
  std::vector<std::shared_ptr<const agent::Behaviour>> behaviours_;
  std::vector<Seat> a_, b_;  // by the place of the game in the pair
  std::string specification_;
};

}  // namespace sim::app
