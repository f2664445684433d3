// The deeds of a tree over many games: how often and how long each of its parts runs, and the goals that follow.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "sim/agent/tree.h"
#include "sim/match/params.h"
#include "sim/match/state.h"

namespace sim::debug {

inline constexpr float kOutlook = 30;       // [s] how long goals count for a decision
inline constexpr float kInterrupted = 0.5;  // [s] a part that begins again so soon has only been interrupted

/// A part of a tree: all that lies below a name. A leaf is a part, too. Names in which nothing but one other name lies
/// are one part.
struct Part {
  std::string path;   // names from the root, joined by "/"
  std::string name;   // the outermost of those that are this part
  int depth = 0;      // number of parts around it
  std::string skill;  // of a leaf; otherwise empty
};

/// The parts of a tree, each after the one in which it lies, in the order in which the tree compares.
class Parts {
 public:
  /// `tree` outlives it.
  explicit Parts(const agent::Tree& tree);

  const agent::Tree& tree() const { return tree_; }
  const std::vector<Part>& all() const { return all_; }
  /// Returns the numbers of the parts in which a leaf lies, the whole tree first and the leaf itself last.
  const std::vector<std::size_t>& around(std::uint16_t leaf) const { return around_[leaf]; }

 private:
  const agent::Tree& tree_;
  std::vector<Part> all_;
  std::vector<std::vector<std::size_t>> around_;  // by leaf
};

/// Sums over games of one part. They are whole numbers, so that the order of the games does not matter.
struct Visits {
  std::int64_t decisions = 0;    // through this part
  std::int64_t ticks = 0;        // that robots spent in it
  std::int64_t stays = 0;        // uninterrupted runs of decisions through it
  std::int64_t interrupted = 0;  // stays that began less than kInterrupted after the last one of the robot
  // The gain of a decision: goals of the own side minus goals of the other within kOutlook. Sums of each game's gain g
  // and number n of decisions:
  std::int64_t gain = 0, gain_squares = 0, gain_decisions = 0, decision_squares = 0;  // g, g², g·n, n²

  void add(const Visits& other);
};

/// The answers of one comparison.
struct Asked {
  std::int64_t yes = 0, no = 0;
  std::int64_t unknown = 0;  // of `no`: the robot did not know a value

  std::int64_t times() const { return yes + no; }
};

/// The coverage of a tree by games.
struct Coverage {
  std::int64_t games = 0;
  std::vector<Visits> parts;       // as Parts::all
  std::vector<Asked> comparisons;  // by the number of the node

  void add(const Coverage& other);
};

inline constexpr std::int64_t kFewGames = 4;  // fewer say too little about others

/// A mean with its interval.
struct MeanGain {
  double mean = 0;        // [goals]
  double half_width = 0;  // of the 95 % interval [goals]; infinite for fewer than kFewGames
};

/// Returns the mean gain of the decisions through a part. Decisions of one game depend on each other, so the interval
/// is that of a ratio of sums over games (Cochran, Sampling Techniques, 1977, section 6.4), by Student's t.
MeanGain gain_of(const Visits& visits, std::int64_t games);

/// Plays on from `state` to the end, or for at most `most` ticks, and watches the robots of `side` that play the tree of
/// `parts`. `state` becomes the last one.
Coverage watch_game(const Params& params, State& state, Side side, const Parts& parts, Tick most = kNever);

}  // namespace sim::debug
