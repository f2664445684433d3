#include "sim/contest/contest.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdlib>
#include <map>
#include <unordered_set>

#include "sim/contest/crew.h"
#include "sim/contest/repetition.h"

namespace sim::contest {
namespace {

using robot::Error;
using robot::Result;
using Clock = Crew::Clock;
using Pairs = std::vector<compare::Pair>;

constexpr std::int64_t kPerBlock = RunFolder::kPairsPerBlock;
constexpr std::size_t kDecisive = 5;  // kept per behaviour
constexpr std::size_t kMostMarks = 400;
constexpr std::int64_t kAhead = 4;  // blocks per job that are played ahead of the judged one
constexpr std::size_t kListed = 8;  // missing blocks in an error

double since(Clock::time_point start) { return std::chrono::duration<double>(Clock::now() - start).count(); }

/// Adds a pair, and keeps the pairs with the largest gains of each behaviour.
void note(std::vector<DecisivePair>& decisive, DecisivePair pair) {
  if (pair.gain == 0) return;
  const auto larger = [](const DecisivePair& a, const DecisivePair& b) {
    return std::abs(a.gain) != std::abs(b.gain) ? std::abs(a.gain) > std::abs(b.gain) : a.number < b.number;
  };
  const bool for_b = pair.gain > 0;
  decisive.insert(std::ranges::upper_bound(decisive, pair, larger), pair);
  std::size_t same = 0;
  std::erase_if(decisive, [&](const DecisivePair& each) { return (each.gain > 0) == for_b && ++same > kDecisive; });
}

/// Adds a mark. Removes every second one when there are too many; the last always stays.
void add_mark(std::vector<Mark>& marks, const Mark& mark) {
  marks.push_back(mark);
  if (marks.size() <= kMostMarks) return;
  std::vector<Mark> fewer;
  for (std::size_t i = 0; i < marks.size(); ++i)
    if (i % 2 == 1 || i + 1 == marks.size()) fewer.push_back(marks[i]);
  marks = std::move(fewer);
}

/// Adds blocks in their order and holds the verdict so far.
class Judge {
 public:
  Judge(const Comparison& comparison, const ContestOptions& options)
      : unit_(comparison.unit()),
        column_(column_of(comparison.choice().metric)),
        models_(comparison.choice().models),
        options_(options) {
    outcome_.histogram.resize(2 * Outcome::kWidest + 1);
  }

  /// Returns the mark behind the block, or an Error if its pairs are repetitions.
  Result<Mark> take(std::int64_t block, const Pairs& pairs) {
    const std::int64_t wanted = options_.pairs.value_or(options_.most_pairs);
    for (std::int64_t i = 0; i < kPerBlock && block * kPerBlock + i < wanted; ++i)
      take_pair(block * kPerBlock + i, pairs[static_cast<std::size_t>(i)]);
    const compare::PairStatistics& tally = outcome_.tally;
    if (outcome_.different < tally.pairs && tally.same < tally.pairs) return repetition();
    add_mark(outcome_.marks, {.pairs = tally.pairs,
                              .gain = compare::gain_per_game(tally, unit_),
                              .llr = compare::llr(tally, options_.question, unit_)});
    if (!options_.pairs) outcome_.verdict = compare::decide(tally, options_.question, unit_);
    return outcome_.marks.back();
  }

  bool undecided() const { return outcome_.verdict == compare::Verdict::undecided; }

  Outcome finish(double seconds, const DecisionCost (&cost)[2]) {
    using compare::Verdict;
    outcome_.sequential = outcome_.verdict == Verdict::better || outcome_.verdict == Verdict::not_better;
    if ((options_.pairs || options_.seconds > 0) && undecided())
      outcome_.verdict = compare::judge(outcome_.tally, options_.question, unit_);
    outcome_.seconds = seconds;
    for (const int behaviour : {0, 1}) outcome_.cost[behaviour] = cost[behaviour];
    return std::move(outcome_);
  }

 private:
  bool is_known(std::uint64_t hash) {
    if (hashes_.size() >= kRemembered) return hashes_.contains(hash);
    return !hashes_.insert(hash).second;
  }

  Error repetition() const {
    return Error{contest::repetition(outcome_.tally.pairs, outcome_.different, "pairs", models_)};
  }

  void take_pair(std::int64_t number, const compare::Pair& pair) {
    outcome_.tally.add(pair);
    if (!is_known(pair.hash)) ++outcome_.different;
    const int gain = pair.games[0].gain + pair.games[1].gain;
    note(outcome_.decisive, {.number = number, .gain = gain});
    const auto column = static_cast<int>(std::lround(gain / (unit_ * column_)));
    const int bar = std::clamp(column, -Outcome::kWidest, Outcome::kWidest) + Outcome::kWidest;
    ++outcome_.histogram[static_cast<std::size_t>(bar)];
  }

  const double unit_, column_;
  const std::string models_;
  const ContestOptions& options_;
  Outcome outcome_;
  std::unordered_set<std::uint64_t> hashes_;  // of the different pairs, at most kRemembered
};

/// Blocks from the disk or from workers. A limited number is played ahead of the requested one.
class Blocks {
 public:
  Blocks(const Comparison& comparison, const RunFolder* folder, std::int64_t from, std::int64_t to, int jobs)
      : crew_(comparison, jobs), folder_(folder), next_(from), to_(to), ahead_(kAhead * jobs) {}

  /// Returns the pairs of `block`, or nothing if they are not there by `deadline`.
  std::optional<Result<Pairs>> take(std::int64_t block, Clock::time_point deadline) {
    while (!done_.contains(block)) {
      if (auto given = give_out(block + ahead_); !given) return given.failure();
      if (done_.contains(block)) break;
      auto played = crew_.wait(deadline);
      if (!played) return {};
      if (!*played) return played->failure();
      PlayedBlock& found = **played;
      for (const int behaviour : {0, 1}) cost_[behaviour].add(found.cost[behaviour]);
      if (folder_)
        if (auto written = folder_->write(found.number, found.pairs); !written) return written.failure();
      done_.emplace(found.number, std::move(found.pairs));
    }
    return std::move(done_.extract(block).mapped());
  }

  const DecisionCost (&cost() const)[2] { return cost_; }

 private:
  Result<void> give_out(std::int64_t until) {
    while (next_ < std::min(until, to_) && crew_.has_somebody_idle()) {
      const std::int64_t block = next_++;
      if (folder_)
        if (auto there = folder_->read(block)) {
          done_.emplace(block, *std::move(there));
          continue;
        }
      if (auto given = crew_.give(block); !given) return given;
    }
    return {};
  }

  Crew crew_;
  const RunFolder* const folder_;
  std::map<std::int64_t, Pairs> done_;
  std::int64_t next_;
  const std::int64_t to_;
  const std::int64_t ahead_;  // largest number of waiting blocks, so that memory does not grow
  DecisionCost cost_[2];
};

Clock::time_point far_off(Clock::time_point start) { return start + std::chrono::hours(24 * 365); }

}  // namespace

Result<Outcome> play_contest(const Comparison& comparison, const ContestOptions& options, const RunFolder* folder,
                             const std::function<void(const Mark&, double)>& progress) {
  const Clock::time_point start = Clock::now();
  const Clock::time_point deadline =
      options.seconds > 0
          ? start + std::chrono::duration_cast<Clock::duration>(std::chrono::duration<double>(options.seconds))
          : far_off(start);
  const std::int64_t blocks = options.most_blocks();
  Judge judge(comparison, options);
  Blocks played(comparison, folder, 0, blocks, options.jobs);
  for (std::int64_t block = 0; block < blocks && judge.undecided(); ++block) {
    const auto pairs = played.take(block, deadline);
    if (!pairs) break;
    if (!*pairs) return pairs->failure();
    const auto mark = judge.take(block, **pairs);
    if (!mark) return mark.failure();
    if (progress) progress(*mark, static_cast<double>(2 * mark->pairs) * 60 / since(start));
  }
  return judge.finish(since(start), played.cost());
}

Result<void> play_blocks(const Comparison& comparison, std::int64_t from, std::int64_t to, int jobs,
                         const RunFolder& folder) {
  Blocks played(comparison, &folder, from, to, jobs);
  for (std::int64_t block = from; block < to; ++block) {
    const auto pairs = played.take(block, far_off(Clock::now()));
    if (pairs && !*pairs) return pairs->failure();
  }
  return {};
}

Result<Outcome> merge(const Comparison& comparison, const ContestOptions& options, const RunFolder& folder) {
  const Clock::time_point start = Clock::now();
  const std::int64_t blocks = options.pairs ? options.most_blocks() : folder.blocks();
  if (blocks == 0) return Error{"run " + folder.path().string() + ": expected blocks of games, there are none"};
  std::string missing;
  std::size_t count = 0;
  for (std::int64_t block = 0; block < blocks; ++block)
    if (!folder.has(block) && ++count <= kListed) missing += (missing.empty() ? "" : ", ") + std::to_string(block);
  if (count > 0)
    return Error{"run " + folder.path().string() + ": expected " + std::to_string(blocks) + " blocks, " +
                 std::to_string(count) + " are missing: " + missing + (count > kListed ? ", …" : "")};

  Judge judge(comparison, options);
  for (std::int64_t block = 0; block < blocks; ++block) {
    const auto pairs = folder.read(block);
    if (!pairs) return pairs.failure();
    // blocks after the answer are checked but not judged
    if (!judge.undecided()) continue;
    if (const auto mark = judge.take(block, *pairs); !mark) return mark.failure();
  }
  return judge.finish(since(start), {});
}

}  // namespace sim::contest
