#include "sim/app/compare_runs.h"

#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <optional>

#include "robot/core/json_library.h"
#include "sim/app/commands.h"
#include "sim/contest/slurm.h"
#include "sim/report/contest_plan.h"
#include "sim/report/contest_report.h"
#include "sim/report/robust.h"

namespace sim::app {
namespace {

constexpr std::int64_t kPilotPairs = 200;
constexpr std::int64_t kPairedPairs = 50, kUnpairedPairs = 1000;  // for a behaviour against itself
constexpr int kVerified = 2;                                      // number of verified blocks

/// Estimates the number of pairs still to be played. A sequential test is assumed to go on at its rate so far.
double pairs_left(const contest::ContestOptions& options, const contest::Mark& mark) {
  const auto played = static_cast<double>(mark.pairs);
  if (options.pairs) return static_cast<double>(*options.pairs) - played;
  const compare::Bounds bounds = compare::bounds_of(options.question);
  const double bound = mark.llr > 0 ? bounds.h1 : bounds.h0;
  const double most = static_cast<double>(options.most_pairs) - played;
  return mark.llr == 0 ? most : std::clamp(played * (bound - mark.llr) / mark.llr, 0., most);
}

}  // namespace

int status_of(compare::Verdict verdict) {
  switch (verdict) {
    case compare::Verdict::better: return kDone;
    case compare::Verdict::undecided:
    case compare::Verdict::too_rare: return kUndecided;
    default: return kNo;
  }
}

std::function<void(const contest::Mark&, double)> progress_line(const contest::ContestOptions& options) {
  if (isatty(STDERR_FILENO) == 0) return {};
  return [options](const contest::Mark& mark, double games_per_minute) {
    const compare::Bounds bounds = compare::bounds_of(options.question);
    std::fprintf(stderr,
                 "\rpairs %lld  gain %+.3f ± %.3f  LLR %+.2f of %+.2f, %+.2f  %.0f games/min  %.0f s left \033[K",
                 static_cast<long long>(mark.pairs), mark.gain.mean, mark.gain.high - mark.gain.mean, mark.llr,
                 bounds.h0, bounds.h1, games_per_minute, 120 * pairs_left(options, mark) / games_per_minute);
    std::fflush(stderr);
  };
}

void clear_line() {
  if (isatty(STDERR_FILENO) != 0) std::fputs("\r\033[K", stderr);
}

int run_plan(const CompareTask& task, const contest::Comparison& comparison) {
  contest::ContestOptions pilot = task.contest;
  if (task.delta > 0) pilot.question.h1 = pilot.question.h0 + task.delta, pilot.question.part = 0;
  // --pilot gives the variance; a few pairs played here give the time of a pair
  const bool played_before = !task.pilot.empty();
  pilot.pairs = played_before ? contest::RunFolder::kPairsPerBlock : task.pairs > 0 ? task.pairs : kPilotPairs;
  auto outcome = contest::play_contest(comparison, pilot, nullptr, progress_line(task.contest));
  clear_line();
  if (!outcome) return fail(outcome.error());
  if (played_before) {
    const double seconds_per_pair = outcome->seconds / static_cast<double>(outcome->tally.pairs);
    const auto folder =
        contest::RunFolder::open(task.pilot, comparison.specification(), contest::RunFolder::Use::share);
    if (!folder) return fail(folder.error());
    pilot.pairs = folder->blocks() * contest::RunFolder::kPairsPerBlock;
    outcome = merge(comparison, pilot, *folder);
    if (!outcome) return fail(outcome.error());
    outcome->seconds = seconds_per_pair * static_cast<double>(outcome->tally.pairs);
  }
  if (outcome->tally.gain_squares == 0)
    return fail("--plan: the pilot's " + std::to_string(outcome->tally.pairs) +
                " pairs all came out even, so the variance is unknown; try more with --pairs");
  const report::ContestReport report{comparison, pilot, *outcome};
  if (task.json)
    std::printf("%s\n", report::plan_json(report).dump(2).c_str());
  else
    std::fputs(report::plan_text(report).c_str(), stdout);
  return kDone;
}

int run_robust(CompareTask task) {
  std::vector<contest::Conditions> conditions = contest::robust_conditions(!task.choice.opponent.empty());
  conditions.insert(conditions.begin(), contest::Conditions{});
  std::vector<report::UnderConditions> found;
  for (const contest::Conditions& each : conditions) {
    task.choice.conditions = each;
    const auto comparison = contest::Comparison::prepare(task.choice);
    if (!comparison) return fail(comparison.error());
    const auto outcome = contest::play_contest(*comparison, task.contest, nullptr, progress_line(task.contest));
    clear_line();
    if (!outcome) return fail(outcome.error());
    found.push_back({.conditions = each.name,
                     .verdict = outcome->verdict,
                     .gain = compare::gain_per_game(outcome->tally, comparison->unit()),
                     .pairs = outcome->tally.pairs});
  }
  if (task.json)
    std::printf("%s\n", report::robust_json(task.choice, found).dump(2).c_str());
  else
    std::fputs(report::robust_text(task.choice, found).c_str(), stdout);
  return status_of(found.front().verdict);
}

namespace {

/// A behaviour against itself: pairs of the same luck, and games of other luck.
struct Itself {
  const CompareTask& task;
  compare::PairStatistics paired, unpaired;

  double unit() const { return contest::unit_of(task.choice.metric); }
  bool even() const { return paired.same == paired.pairs && paired.gain_squares == 0; }
  bool too_rare() const { return unpaired.eventful_games < compare::kFewestUneven; }
  compare::Interval advantage() const { return compare::home_advantage(unpaired, unit()); }
  bool fair() const { return advantage().low <= 0 && advantage().high >= 0; }

  int status() const {
    if (!even() || !fair()) return kNo;
    return too_rare() ? kUndecided : kDone;
  }
};

report::Json json_of(const Itself& itself) {
  const compare::Interval bias = itself.advantage();
  return {{"behaviour", itself.task.choice.a},
          {"paired",
           {{"pairs", itself.paired.pairs},
            {"gain", compare::gain_per_game(itself.paired, itself.unit()).mean},
            {"even", itself.even()}}},
          {"unpaired",
           {{"games", 2 * itself.unpaired.pairs},
            {"eventful_games", itself.unpaired.eventful_games},
            {"too_rare", itself.too_rare()},
            {"home_advantage", {{"mean", bias.mean}, {"low", bias.low}, {"high", bias.high}}},
            {"fair", itself.fair()}}}};
}

std::string advantage_text(const Itself& itself) {
  const long long games = 2 * itself.unpaired.pairs, eventful = itself.unpaired.eventful_games;
  char text[300];
  if (itself.too_rare()) {
    std::snprintf(text, sizeof text,
                  "too rare to tell a home advantage: %lld of %lld games had a gain; raise --pairs or choose a longer "
                  "metric",
                  eventful, games);
    return text;
  }
  const compare::Interval bias = itself.advantage();
  std::snprintf(text, sizeof text, "%lld games of other luck%s   home advantage %+.4f (95 %%: %+.4f .. %+.4f), %s",
                games, itself.task.choice.situation.empty() ? "" : ", each moment as often for either side", bias.mean,
                bias.low, bias.high, itself.fair() ? "none that shows" : "one end of the field IS better");
  return text;
}

}  // namespace

int run_itself(CompareTask task) {
  contest::ContestOptions paired = task.contest, unpaired = task.contest;
  paired.pairs = kPairedPairs;
  unpaired.pairs = task.pairs > 0 ? task.pairs : kUnpairedPairs;
  Itself itself{.task = task, .paired = {}, .unpaired = {}};
  for (const bool is_unpaired : {false, true}) {
    task.choice.unpaired = is_unpaired;
    const auto comparison = contest::Comparison::prepare(task.choice);
    if (!comparison) return fail(comparison.error());
    const auto outcome =
        contest::play_contest(*comparison, is_unpaired ? unpaired : paired, nullptr, progress_line(task.contest));
    clear_line();
    if (!outcome) return fail(outcome.error());
    (is_unpaired ? itself.unpaired : itself.paired) = outcome->tally;
  }
  if (task.json) {
    std::printf("%s\n", json_of(itself).dump(2).c_str());
    return itself.status();
  }
  const compare::Interval gain = compare::gain_per_game(itself.paired, itself.unit());
  std::printf("%s against itself\n", task.choice.a.c_str());
  std::printf("  %lld pairs of the same luck   gain %+.3f ± %.3f, %s\n", static_cast<long long>(itself.paired.pairs),
              gain.mean, gain.high - gain.mean, itself.even() ? "0 in each, as it must be" : "NOT 0 in each");
  std::printf("  %s\n", advantage_text(itself).c_str());
  return itself.status();
}

int run_blocks(const CompareTask& task, const contest::Comparison& comparison, const contest::RunFolder& folder) {
  long long from = 0, to = 0;
  int used = 0;
  if (std::sscanf(task.blocks.c_str(), "%lld..%lld%n", &from, &to, &used) != 2 ||
      used != static_cast<int>(task.blocks.size()) || from < 0 || from >= to)
    return fail("--blocks: expected the first one and the one behind the last, such as 0..40, got '" + task.blocks +
                "'");
  const auto played = contest::play_blocks(comparison, from, to, task.contest.jobs, folder);
  return played ? kDone : fail(played.error());
}

int run_verify(const CompareTask& task, const contest::Comparison& comparison, const contest::RunFolder& folder) {
  std::int64_t blocks = 0;
  while (folder.read(blocks)) ++blocks;
  if (blocks == 0) return fail("run " + task.out + ": expected at least one block of games, there is none");
  int differing = 0;
  const std::int64_t chosen[kVerified] = {static_cast<std::int64_t>(task.choice.seed) % blocks, blocks - 1};
  for (const std::int64_t block : chosen) {
    const auto kept = folder.read(block);
    constexpr std::int64_t kPairs = contest::RunFolder::kPairsPerBlock;
    const auto played = comparison.play(block * kPairs, kPairs);
    if (!played) return fail(played.error());
    const bool same = std::ranges::equal(played->pairs, *kept);
    if (!same) ++differing;
    std::printf("block %lld: %s\n", static_cast<long long>(block), same ? "identical" : "NOT identical");
  }
  return differing == 0 ? kDone : kNo;
}

int run_slurm(const CompareTask& task, const contest::Comparison& comparison, const contest::RunFolder& folder,
              const std::vector<std::string>& words) {
  // the time of a block decides the number of blocks per task
  const auto start = std::chrono::steady_clock::now();
  if (const auto played = comparison.play(0, contest::RunFolder::kPairsPerBlock); !played) return fail(played.error());
  const std::chrono::duration<double> seconds = std::chrono::steady_clock::now() - start;
  const contest::Division division = contest::divide(task.contest.most_blocks(), seconds.count());
  const auto submitted = contest::submit(words, division, folder);
  if (!submitted) return fail(submitted.error());
  std::printf("%lld blocks in %lld tasks: job %s; their verdict: job %s, in %s/result.json\n",
              static_cast<long long>(division.blocks), static_cast<long long>(division.tasks()),
              submitted->array.c_str(), submitted->merge.c_str(), task.out.c_str());
  return kDone;
}

}  // namespace sim::app
