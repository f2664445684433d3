// The arena: strategies play exercises on given seeds.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "robot/core/result.h"
#include "sim/agent/tree.h"
#include "sim/contest/conditions.h"
#include "sim/contest/series.h"
#include "sim/drills/starts.h"
#include "sim/io/json.h"
#include "sim/learn/ledger.h"
#include "sim/match/params.h"

namespace sim::learn {

/// The world in which a run learns.
struct World {
  std::string rules = "spl2012", models = "match";    // of whole games; a drill has its own
  std::vector<std::string> opponents = {"baseline"};  // of whole games, in turn
  bool robust = false;                                // play under each of contest::robust_conditions() in turn
  int threads = 1;
};

/// The scores of one strategy, by exercise and seed.
using Scores = std::vector<std::vector<Score>>;

/// Exercises with their weights, prepared. Used by one thread, which shares the games among others.
class Arena {
 public:
  /// `exercises` are drills or kGame, with weights. `ledger` outlives the arena.
  static robot::Result<Arena> prepare(const std::vector<std::pair<std::string, double>>& exercises, const World& world,
                                      Ledger& ledger);

  /// Plays each exercise with each strategy, on `count` seeds from `first_seed` on; of whole games, a quarter of that.
  /// A strategy's scores depend on nothing but itself, the seeds and the world. Results in the ledger are not played again.
  /// The Error of a strategy that cannot play names it.
  robot::Result<std::vector<Scores>> play(std::span<const io::Json> strategies, std::uint64_t first_seed, int count);

  /// Returns the weighted mean of the exercises' mean points.
  double value_of(const Scores& scores) const;
  /// Returns the gain of `b` over `a` on the same seeds: the weighted mean of the differences, with its standard error.
  contest::Mean gain_of(const Scores& a, const Scores& b) const;
  int threads() const { return threads_; }
  std::size_t size() const { return exercises_.size(); }
  /// Returns the number of attempts that `count` seeds give at an exercise.
  int attempts_of(std::size_t exercise, int count) const;
  /// Returns the diagonal of the largest field [m].
  float diagonal() const;
  /// Returns the simulated seconds of `count` seeds, an estimate.
  double cost_of(int count) const;

  /// A prepared exercise.
  struct Exercise {
    std::string name;
    double weight = 1;
    bool is_game = false;
    std::shared_ptr<const drills::Drill> drill;
    std::optional<drills::Starts> starts;
    // by condition, and of whole games by opponent; the behaviours that they point to are in `held`
    std::vector<Params> params;
    std::vector<std::shared_ptr<const agent::Behaviour>> held;
  };
  const Exercise& exercise(std::size_t index) const { return exercises_[index]; }

  /// Some attempts at one exercise by one strategy.
  struct Task {
    std::size_t strategy = 0, exercise = 0;
    int from = 0;  // the first of its attempts
    std::uint64_t seed = 0;
    std::uint64_t key = 0;  // in the ledger
    std::vector<Score> scores;
  };

 private:
  Arena(Ledger& ledger, int threads) : ledger_(&ledger), threads_(threads) {}
  /// Adds the tasks of a strategy, whose text has this hash.
  void add_tasks(std::size_t strategy, std::uint64_t hash, std::uint64_t first_seed, int count,
                 std::vector<Task>& tasks) const;
  /// Takes the scores from the ledger, if they are there.
  bool take_known(Task& task) const;
  /// Plays the tasks that neither this process nor another one of the run has played.
  robot::Result<void> play_tasks(const std::vector<std::unique_ptr<agent::TreeBehaviour>>& trees,
                                 std::vector<Task>& tasks);
  /// Returns the weighted mean over the exercises of the means of value(exercise).
  template <class Value>
  contest::Mean weighted(Value&& value) const;

  Ledger* ledger_;
  int threads_;
  std::vector<Exercise> exercises_;
  std::uint64_t world_hash_ = 0;
};

/// Returns the variant of a drill's parameters that an attempt has. Attempts in a row play side by side, so each variant
/// has a part of each task in a row.
std::size_t variant_of(int attempt, int attempts, std::size_t variants);

/// Returns the number of attempts that succeeded.
int successes_in(const std::vector<Score>& scores);
/// Returns the gain of `b` over `a` in the share of successes, on the same seeds.
contest::Mean success_gain(const std::vector<Score>& a, const std::vector<Score>& b);

}  // namespace sim::learn
