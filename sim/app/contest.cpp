#include "sim/app/contest.h"

#include <algorithm>
#include <chrono>
#include <condition_variable>
#include <cstdlib>
#include <map>
#include <mutex>
#include <thread>

namespace sim::app {
namespace {

using Clock = std::chrono::steady_clock;
constexpr std::int64_t kPerBlock = RunFolder::kPairsPerBlock;
constexpr std::size_t kDecisive = 5;  // of either behaviour
constexpr std::size_t kMostMarks = 400;

double since(Clock::time_point start) { return std::chrono::duration<double>(Clock::now() - start).count(); }

/// Blocks that are being played ahead of the one that is judged.
class Workers {
 public:
  Workers(const Comparison& comparison, const RunFolder* folder, std::int64_t blocks, int jobs)
      : comparison_(comparison), folder_(folder), blocks_(blocks), ahead_(4 * jobs) {
    for (int i = 0; i < jobs; ++i) threads_.emplace_back([this] { work(); });
  }
  ~Workers() {
    {
      const std::lock_guard guard(lock_);
      stopping_ = true;
    }
    changed_.notify_all();
    for (std::thread& thread : threads_) thread.join();
  }

  /// The pairs of `block`; nothing when it is not there by `deadline`.
  std::optional<robot::Result<std::vector<compare::Pair>>> take(std::int64_t block, Clock::time_point deadline) {
    std::unique_lock guard(lock_);
    if (!changed_.wait_until(guard, deadline, [&] { return done_.contains(block); })) return {};
    auto pairs = std::move(done_.extract(block).mapped());
    judged_ = block + 1;
    guard.unlock();
    changed_.notify_all();
    return pairs;
  }

 private:
  void work() {
    while (true) {
      std::int64_t block = 0;
      {
        std::unique_lock guard(lock_);
        changed_.wait(guard, [&] { return stopping_ || next_ >= blocks_ || next_ < judged_ + ahead_; });
        if (stopping_ || next_ >= blocks_) return;
        block = next_++;
      }
      auto pairs = pairs_of(block);
      {
        const std::lock_guard guard(lock_);
        done_.emplace(block, std::move(pairs));
      }
      changed_.notify_all();
    }
  }

  robot::Result<std::vector<compare::Pair>> pairs_of(std::int64_t block) {
    if (folder_)
      if (auto pairs = folder_->read(block)) return *std::move(pairs);
    std::vector<compare::Pair> pairs;
    for (std::int64_t i = 0; i < kPerBlock; ++i) {
      {
        const std::lock_guard guard(lock_);
        if (stopping_) return pairs;
      }
      pairs.push_back(comparison_.play(block * kPerBlock + i));
    }
    if (folder_)
      if (auto written = folder_->write(block, pairs); !written) return robot::Error{written.error()};
    return pairs;
  }

  const Comparison& comparison_;
  const RunFolder* const folder_;
  const std::int64_t blocks_;
  const std::int64_t ahead_;  // so many blocks wait at most: memory does not grow

  std::mutex lock_;
  std::condition_variable changed_;
  std::map<std::int64_t, robot::Result<std::vector<compare::Pair>>> done_;
  std::int64_t next_ = 0, judged_ = 0;
  bool stopping_ = false;
  std::vector<std::thread> threads_;
};

/// Keeps the pairs with the largest gain of either behaviour.
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

void take_in(Outcome& outcome, std::int64_t number, const compare::Pair& pair) {
  outcome.tally.add(pair);
  const int gain = pair.games[0].gain + pair.games[1].gain;
  note(outcome.decisive, {.number = number, .gain = gain});
  const int column = std::clamp(gain, -Outcome::kWidest, Outcome::kWidest) + Outcome::kWidest;
  ++outcome.histogram[static_cast<std::size_t>(column)];
}

/// Every second one goes when there are too many; the last always stays.
void add_mark(std::vector<Mark>& marks, const Mark& mark) {
  marks.push_back(mark);
  if (marks.size() <= kMostMarks) return;
  std::vector<Mark> fewer;
  for (std::size_t i = 0; i < marks.size(); ++i)
    if (i % 2 == 1 || i + 1 == marks.size()) fewer.push_back(marks[i]);
  marks = std::move(fewer);
}

}  // namespace

robot::Result<Outcome> play_contest(const Comparison& comparison, const ContestOptions& options,
                                    const RunFolder* folder, const std::function<void(const Mark&, double)>& progress) {
  const Clock::time_point start = Clock::now();
  const Clock::time_point deadline =
      options.seconds > 0
          ? start + std::chrono::duration_cast<Clock::duration>(std::chrono::duration<double>(options.seconds))
          : start + std::chrono::hours(24 * 365);
  const std::int64_t wanted = options.pairs.value_or(options.most_pairs);
  const std::int64_t blocks = (wanted + kPerBlock - 1) / kPerBlock;
  Outcome outcome;
  outcome.histogram.resize(2 * Outcome::kWidest + 1);
  {
    Workers workers(comparison, folder, blocks, options.jobs);
    for (std::int64_t block = 0; block < blocks && outcome.verdict == compare::Verdict::undecided; ++block) {
      const auto pairs = workers.take(block, deadline);
      if (!pairs) break;
      if (!*pairs) return robot::Error{pairs->error()};
      for (std::int64_t i = 0; i < kPerBlock && block * kPerBlock + i < wanted; ++i)
        take_in(outcome, block * kPerBlock + i, (**pairs)[static_cast<std::size_t>(i)]);
      const Mark mark{.pairs = outcome.tally.pairs,
                      .gain = compare::gain_per_game(outcome.tally),
                      .llr = compare::llr(outcome.tally, options.question)};
      add_mark(outcome.marks, mark);
      if (progress) progress(mark, static_cast<double>(2 * outcome.tally.pairs) * 60 / since(start));
      if (!options.pairs) outcome.verdict = compare::decide(outcome.tally, options.question);
    }
  }
  if (options.pairs || options.seconds > 0) {
    if (outcome.verdict == compare::Verdict::undecided)
      outcome.verdict = compare::judge(outcome.tally, options.question);
  }
  outcome.seconds = since(start);
  return outcome;
}

}  // namespace sim::app
