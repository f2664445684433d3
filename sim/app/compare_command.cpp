// foresight-sim compare: is behaviour B better than A?
#include <unistd.h>

#include <cmath>
#include <cstdio>
#include <optional>

#include "sim/app/commands.h"
#include "sim/app/contest.h"
#include "sim/app/contest_report.h"
#include "sim/app/series.h"

namespace sim::app {
namespace {

constexpr std::int64_t kPilotPairs = 200;
constexpr int kVerified = 2;  // blocks

class CompareCommand final : public Command {
 public:
  explicit CompareCommand(CLI::App& app)
      : Command(app.add_subcommand("compare", "is behaviour B better than A? pairs of games with the same luck")) {
    options().add_option("a", choice_.a, "strategy: name or file")->required();
    options().add_option("b", choice_.b, "strategy; A against itself if not given, which must come out as identical");
    options().add_option("--vs", choice_.opponent, "a third strategy that both play against, instead of each other");
    add_world();
    add_length();
    options().add_option("--out", out_, "folder that keeps what was played");
    options().add_flag("--resume", resume_, "go on with what is in --out");
    options().add_flag("--verify", verify_, "play two blocks of --out again and compare them");
    options().add_flag("--plan", plan_, "say how many games an answer takes, from a pilot of 200 pairs");
    options().add_flag("--explain", explain_, "name the pairs that one of them won most clearly, and how to see them");
    options().add_flag("--json", json_, "report as JSON");
    options().footer("Exit status: 0 B is better, 1 it is not, 3 undecided, 2 bad usage or input.");
  }

  int run() override {
    if (choice_.b.empty()) choice_.b = choice_.a;
    if (const std::string wrong = read_words(); !wrong.empty()) return fail(wrong);
    const auto comparison = Comparison::prepare(choice_);
    if (!comparison) return fail(comparison.error());
    if (plan_) return run_plan(*comparison);

    std::optional<RunFolder> folder;
    if (!out_.empty()) {
      auto opened = RunFolder::open(out_, comparison->specification(), resume_ || verify_);
      if (!opened) return fail(opened.error());
      folder.emplace(*std::move(opened));
    } else if (resume_ || verify_) {
      return fail("--resume and --verify need --out, the folder of the run");
    }
    if (verify_) return run_verify(*comparison, *folder);

    const auto outcome = play_contest(*comparison, contest_, folder ? &*folder : nullptr, line());
    if (isatty(STDERR_FILENO) != 0) std::fputs("\r\033[K", stderr);
    if (!outcome) return fail(outcome.error());
    const ContestReport report{*comparison, contest_, *outcome};
    if (json_)
      std::printf("%s\n", to_json(report).dump(2).c_str());
    else
      std::fputs(to_text(report, explain_).c_str(), stdout);
    return status_of(outcome->verdict);
  }

 private:
  static constexpr int kNo = 1, kUndecided = 3;

  void add_world() {
    options()
        .add_option("--rules", choice_.rules, "a year's: name, name:players, name,field=value or file")
        ->capture_default_str();
    options()
        .add_option("--models", choice_.models, "what robots can do: name, name,effect=off or file")
        ->capture_default_str();
    options()
        .add_option("--players", choice_.players, "a side; as the rules say when not given")
        ->check(CLI::Range(1, kMaxPlayers));
    options().add_flag("--every-tick", every_tick_, "everybody decides 30 times a second, also far from the ball");
    options()
        .add_option("--from", choice_.situation, "a described moment in which games begin")
        ->check(CLI::ExistingFile);
    options()
        .add_option("--seconds", choice_.seconds, "how long a game goes on at most, getting ready included")
        ->check(CLI::Range(1., 36000.));
    options()
        .add_option("--metric", metric_, "goals, first_goal, conceded (with --vs), or score_within:30s")
        ->capture_default_str();
    options()
        .add_option("--seed", choice_.seed, "of the first pair; each pair has the next")
        ->check(CLI::Range(std::uint64_t{0}, std::uint64_t{1} << 52))
        ->capture_default_str();
  }

  void add_length() {
    CLI::Option* const sprt = options()
                                  .add_option("--sprt", question_, "H0,H1: a sequential test of these gains per game")
                                  ->capture_default_str();
    CLI::Option* const pairs =
        options().add_option("--pairs", pairs_, "so many pairs of games instead")->check(CLI::Range(2, 10'000'000));
    options()
        .add_option("--time", contest_.seconds, "stop after so many seconds, answer or not")
        ->check(CLI::Range(1., 1e6));
    options()
        .add_option("--jobs", contest_.jobs, "threads; as many as there are processors if not given")
        ->check(CLI::Range(1, 256));
    pairs->excludes(sprt);
    contest_.jobs = threads_for(1 << 20);
  }

  /// What CLI11 leaves as text; a sentence if it makes no sense.
  std::string read_words() {
    choice_.pace = every_tick_ ? Pace::every_tick : Pace::thinned;
    compare::Question& question = contest_.question;
    int used = 0;
    if (std::sscanf(question_.c_str(), "%lf,%lf%n", &question.h0, &question.h1, &used) != 2 ||
        used != static_cast<int>(question_.size()) || !(question.h0 < question.h1) || !std::isfinite(question.h1))
      return "--sprt: expected two gains, the smaller one first, such as 0,0.1, got '" + question_ + "'";
    if (pairs_ > 0) contest_.pairs = pairs_;

    double seconds = 0;
    used = 0;
    if (metric_ == "goals") {
      choice_.metric = Metric::goals;
    } else if (metric_ == "first_goal") {
      choice_.metric = Metric::first_goal;
    } else if (metric_ == "conceded") {
      choice_.metric = Metric::conceded;
    } else if (std::sscanf(metric_.c_str(), "score_within:%lfs%n", &seconds, &used) == 1 &&
               used == static_cast<int>(metric_.size()) && seconds >= 1 && seconds <= 36000) {
      choice_.metric = Metric::score_within;
      choice_.seconds = seconds;
    } else {
      return "--metric: expected goals, first_goal, conceded or score_within:30s, got '" + metric_ + "'";
    }
    return "";
  }

  /// What is known so far, on a terminal.
  std::function<void(const Mark&, double)> line() const {
    if (isatty(STDERR_FILENO) == 0) return {};
    return [this](const Mark& mark, double games_per_minute) {
      std::fprintf(stderr, "\rpairs %lld  gain %+.3f ± %.3f  LLR %+.2f of ±%.2f  %.0f games/min \033[K",
                   static_cast<long long>(mark.pairs), mark.gain.mean, mark.gain.high - mark.gain.mean, mark.llr,
                   compare::bounds_of(contest_.question).h1, games_per_minute);
      std::fflush(stderr);
    };
  }

  int run_plan(const Comparison& comparison) {
    ContestOptions pilot = contest_;
    pilot.pairs = pairs_ > 0 ? pairs_ : kPilotPairs;
    const auto outcome = play_contest(comparison, pilot, nullptr, line());
    if (isatty(STDERR_FILENO) != 0) std::fputs("\r\033[K", stderr);
    if (!outcome) return fail(outcome.error());
    if (outcome->tally.gain_squares == 0)
      return fail("--plan: the pilot's " + std::to_string(outcome->tally.pairs) +
                  " pairs all came out even, which tells nothing; try more with --pairs");
    const ContestReport report{comparison, pilot, *outcome};
    if (json_)
      std::printf("%s\n", plan_json(report).dump(2).c_str());
    else
      std::fputs(plan_text(report).c_str(), stdout);
    return kDone;
  }

  /// The first and the last block there are.
  int run_verify(const Comparison& comparison, const RunFolder& folder) {
    std::int64_t blocks = 0;
    while (folder.read(blocks)) ++blocks;
    if (blocks == 0) return fail("run " + out_ + ": expected at least one block of games, there is none");
    int differing = 0;
    const std::int64_t chosen[kVerified] = {static_cast<std::int64_t>(choice_.seed) % blocks, blocks - 1};
    for (const std::int64_t block : chosen) {
      const auto kept = folder.read(block);
      for (std::int64_t i = 0; i < RunFolder::kPairsPerBlock; ++i)
        if (comparison.play(block * RunFolder::kPairsPerBlock + i) != (*kept)[static_cast<std::size_t>(i)]) ++differing;
      std::printf("block %lld: %s\n", static_cast<long long>(block), differing == 0 ? "identical" : "NOT identical");
    }
    return differing == 0 ? kDone : kNo;
  }

  static int status_of(compare::Verdict verdict) {
    switch (verdict) {
      case compare::Verdict::better: return kDone;
      case compare::Verdict::undecided: return kUndecided;
      default: return kNo;
    }
  }

  ComparisonChoice choice_;
  ContestOptions contest_;
  std::string question_ = "0,0.1", metric_ = "goals", out_;
  std::int64_t pairs_ = 0;
  bool every_tick_ = false, resume_ = false, verify_ = false, plan_ = false, explain_ = false, json_ = false;
};

}  // namespace

std::unique_ptr<Command> compare_command(CLI::App& app) { return std::make_unique<CompareCommand>(app); }

}  // namespace sim::app
