// foresight-sim compare: is behaviour B better than A?
#include <cmath>
#include <cstdio>
#include <optional>

#include "robot/core/json_library.h"
#include "sim/app/commands.h"
#include "sim/app/compare_runs.h"
#include "sim/app/decisive_games.h"
#include "sim/contest/series.h"
#include "sim/io/words.h"
#include "sim/report/contest_page.h"
#include "sim/report/contest_report.h"

namespace sim::app {
namespace {

class CompareCommand final : public Command {
 public:
  explicit CompareCommand(CLI::App& app)
      : Command(app.add_subcommand("compare", "is behaviour B better than A? pairs of games with the same luck")) {
    options().add_option("a", choice_.a, "behaviour: name, file, library or pipe:command");
    options().add_option("b", choice_.b, "behaviour; default: A, whose games against itself must be the same games");
    options().add_option("--vs", choice_.opponent, "a third behaviour that both play against, instead of each other");
    options()
        .add_option("--changed", choice_.changed, "number N: on B's side players 1 .. N play B, the others A")
        ->check(CLI::Range(1, kMaxPlayers));
    add_world();
    add_length();
    add_kinds();
    options().add_option("--out", task_.out, "folder that keeps the played games");
    options().add_flag("--resume", resume_, "continue the run in --out");
    options().add_option("--html", html_, "file for an HTML page with plots");
    options().add_option("--games-to", games_to_,
                         "new folder for recordings of the most decisive games, with a page report.html that links to "
                         "them; foresight-lab play serves both");
    options().add_flag("--explain", explain_,
                       "list the pairs with the largest gains, and the commands that replay them");
    options().add_flag("--json", task_.json, "report as JSON");
    options().footer("Exit status: 0 B is better, 1 it is not, 3 undecided or too rare, 2 bad usage or input.");
  }

  int run() override {
    if (const std::string wrong = read_words(); !wrong.empty()) return fail(wrong);
    if (robust_) return run_robust(task_);
    if (!itself_.empty()) return run_itself(task_);
    const auto comparison = contest::Comparison::prepare(choice_);
    if (!comparison) return fail(comparison.error());
    if (plan_) return run_plan(task_, *comparison);

    std::optional<contest::RunFolder> folder;
    if (!task_.out.empty()) {
      auto opened = contest::RunFolder::open(task_.out, comparison->specification(), use());
      if (!opened) return fail(opened.error());
      folder.emplace(*std::move(opened));
    }
    if (verify_) return run_verify(task_, *comparison, *folder);
    if (!task_.blocks.empty()) return run_blocks(task_, *comparison, *folder);
    if (engine_ == "slurm") return run_slurm(task_, *comparison, *folder, words_for_jobs());

    const auto outcome =
        merge_ ? merge(*comparison, contest_, *folder)
               : contest::play_contest(*comparison, contest_, folder ? &*folder : nullptr, progress_line(contest_));
    clear_line();
    if (!outcome) return fail(outcome.error());
    return tell({*comparison, contest_, *outcome}, folder ? &*folder : nullptr);
  }

 private:
  void add_world() {
    options()
        .add_option("--rules", choice_.rules, "rules of a year: name, name:players, name,field=value or file")
        ->capture_default_str();
    options()
        .add_option("--models", choice_.models,
                    "models of the robots: name, name,effect=off or file; player 3 another: name+3=name")
        ->capture_default_str();
    options()
        .add_option("--players", choice_.players, "players per side; by the rules if not given")
        ->check(CLI::Range(1, kMaxPlayers));
    options().add_flag("--every-tick", every_tick_, "all robots decide 30 times a second, also far from the ball");
    options().add_option(
        "--from", choice_.situation,
        "start of the games: name or file of a described moment, or a folder of moments, used in turn");
    options().add_flag("--fuzz", choice_.fuzz, "with --from: each pair begins with slightly shifted robots and ball");
    options()
        .add_option("--seconds", choice_.seconds, "[s] longest game, dead time included")
        ->check(CLI::Range(1., 36000.));
    options()
        .add_option("--metric", metric_,
                    "goals, first_goal, conceded (with --vs), score_within:30s or ball_advance:30s")
        ->capture_default_str();
    options()
        .add_option("--seed", choice_.seed, "seed of the first pair; each later pair has the next seed")
        ->check(CLI::Range(std::uint64_t{0}, std::uint64_t{1} << 52))
        ->capture_default_str();
  }

  void add_length() {
    CLI::Option* const sprt = options().add_option(
        "--sprt", question_,
        "H0,H1: a sequential test of these gains per game; default: 0 and a tenth of the gain's standard deviation");
    CLI::Option* const pairs = options()
                                   .add_option("--pairs", task_.pairs, "a fixed number of pairs instead")
                                   ->check(CLI::Range(2, 10'000'000));
    options()
        .add_option("--most-pairs", contest_.most_pairs,
                    "end as undecided if --sprt has no answer after this number of pairs")
        ->check(CLI::Range(2, 10'000'000))
        ->capture_default_str()
        ->excludes(pairs);
    options()
        .add_option("--time", contest_.seconds, "[s] stop after this time, with or without an answer")
        ->check(CLI::Range(1., 1e6));
    options()
        .add_option("--jobs", contest_.jobs, "number of processes; default: one per processor")
        ->check(CLI::Range(1, 256));
    options()
        .add_option("--engine", engine_,
                    "processes on this machine (local), or jobs of a cluster (slurm, with --pairs)")
        ->check(CLI::IsMember({"local", "slurm"}))
        ->capture_default_str();
    pairs->excludes(sprt);
    contest_.jobs = contest::threads_for(1 << 20);
  }

  /// Adds the other kinds of runs.
  void add_kinds() {
    CLI::Option_group* const kinds = options().add_option_group("instead of the plain verdict");
    kinds->require_option(0, 1);
    kinds->add_flag("--robust", robust_, "repeat the verdict with other walks, kicks and ball noise");
    kinds->add_option("--aa", itself_,
                      "behaviour: compare it with itself; neither copy and no end of the field may gain; with --from "
                      "the sides exchange the moment in half of the games");
    kinds->add_flag("--plan", plan_, "estimate the number of games for an answer, from a pilot of 200 pairs");
    options()
        .add_option("--delta", task_.delta, "with --plan: the gain per game to detect, instead of --sprt's")
        ->check(CLI::Range(1e-6, 100.));
    options()
        .add_option("--pilot", task_.pilot, "with --plan: folder of a run of the same comparison, for its variance")
        ->check(CLI::ExistingDirectory);
    kinds->add_flag("--verify", verify_, "play two blocks of --out again and compare them");
    kinds->add_option("--blocks", task_.blocks,
                      "FROM..TO: play blocks FROM to TO - 1 of --out; other processes may play others");
    kinds->add_flag("--merge", merge_, "judge the blocks in --out, of which none may be missing");
  }

  contest::RunFolder::Use use() const {
    if (!task_.blocks.empty() || merge_ || engine_ == "slurm") return contest::RunFolder::Use::share;
    return resume_ || verify_ ? contest::RunFolder::Use::go_on : contest::RunFolder::Use::begin;
  }

  /// Writes the report to each requested place. Returns the exit status.
  int tell(const report::ContestReport& report, const contest::RunFolder* folder) const {
    const report::Json json = report::to_whole_json(report);
    if (folder)
      if (const auto written = folder->write_result(report::to_json(report).dump(2) + "\n"); !written)
        return fail(written.error());
    if (!html_.empty())
      if (const auto written = robot::replace_file(html_, report::page_of(json)); !written)
        return fail(written.error());
    std::string saved;
    if (!games_to_.empty()) {
      const auto page = save_decisive_games(report, games_to_);
      if (!page) return fail(page.error());
      saved = "\n" + page->string() + ": the most decisive games; foresight-lab play " + games_to_ +
              "/seed-N.mcap serves it at /reports/report.html\n";
    }
    if (task_.json)
      std::printf("%s\n", json.dump(2).c_str());
    else
      std::fputs((report::to_text(report, explain_) + saved).c_str(), stdout);
    return status_of(report.outcome.verdict);
  }

  /// Parses the options that CLI11 leaves as text. Returns an error sentence, or an empty string.
  std::string read_words() {
    if (!itself_.empty()) {
      if (!choice_.a.empty()) return "--aa names the behaviour; got another one: '" + choice_.a + "'";
      choice_.a = itself_;
    }
    if (choice_.a.empty()) return "expected behaviours to compare, such as baseline kick_now";
    if (choice_.b.empty()) choice_.b = choice_.a;
    if ((resume_ || verify_ || merge_ || !task_.blocks.empty()) && task_.out.empty())
      return "--resume, --verify, --merge and --blocks need --out, the folder of the run";
    if (engine_ == "slurm" && (task_.out.empty() || task_.pairs == 0))
      return "--engine slurm needs --pairs, and --out, a folder that all machines of the cluster see";
    if ((robust_ || !itself_.empty()) &&
        (!task_.out.empty() || !html_.empty() || !games_to_.empty() || engine_ == "slurm"))
      return "--robust and --aa are several runs: --out, --html, --games-to and --engine slurm are of one";
    if (!games_to_.empty() && (plan_ || verify_ || !task_.blocks.empty() || engine_ == "slurm"))
      return "--games-to needs a verdict, which --plan, --verify, --blocks and --engine slurm do not have";
    if (!games_to_.empty())
      if (const auto usable = check_games_folder(games_to_); !usable) return usable.error();
    if (task_.delta > 0 && !plan_) return "--delta is for --plan; a test is asked by --sprt";
    choice_.pace = every_tick_ ? Pace::every_tick : Pace::thinned;
    if (task_.pairs > 0) contest_.pairs = task_.pairs;
    if (std::string wrong = read_question(); !wrong.empty()) return wrong;
    return read_metric();
  }

  std::string read_question() {
    compare::Hypothesis& question = contest_.question;
    if (question_.empty()) {
      question.part = compare::kUsualPart;
      return "";
    }
    int used = 0;
    if (std::sscanf(question_.c_str(), "%lf,%lf%n", &question.h0, &question.h1, &used) != 2 ||
        used != static_cast<int>(question_.size()) || !(question.h0 < question.h1) || !std::isfinite(question.h1))
      return "--sprt: expected two gains, the smaller one first, such as 0,0.1, got '" + question_ + "'";
    return "";
  }

  std::string read_metric() {
    double seconds = 0;
    int used = 0;
    const auto timed = [&](const char* format) {
      return std::sscanf(metric_.c_str(), format, &seconds, &used) == 1 && used == static_cast<int>(metric_.size()) &&
             seconds >= 1 && seconds <= 36000;
    };
    if (metric_ == "goals") {
      choice_.metric = contest::Metric::goals;
    } else if (metric_ == "first_goal") {
      choice_.metric = contest::Metric::first_goal;
    } else if (metric_ == "conceded") {
      choice_.metric = contest::Metric::conceded;
    } else if (timed("score_within:%lfs%n")) {
      choice_.metric = contest::Metric::score_within;
      choice_.seconds = seconds;
    } else if (timed("ball_advance:%lfs%n")) {
      choice_.metric = contest::Metric::ball_advance;
      choice_.seconds = seconds;
    } else {
      return "--metric: expected goals, first_goal, conceded, score_within:30s or ball_advance:30s, got '" + metric_ +
             "'" +
             io::did_you_mean(metric_, {"goals", "first_goal", "conceded", "score_within:30s", "ball_advance:30s"});
    }
    return "";
  }

  /// Returns this command line for a job of a cluster: with one process and without an engine.
  std::vector<std::string> words_for_jobs() {
    std::vector<std::string> words = words_again(options(), {"--engine", "--jobs", "--html"});
    words.insert(words.end(), {"--jobs", "1"});
    return words;
  }

  CompareTask task_;
  contest::ComparisonChoice& choice_ = task_.choice;
  contest::ContestOptions& contest_ = task_.contest;
  std::string question_, metric_ = "goals", html_, games_to_, itself_, engine_ = "local";
  bool every_tick_ = false, resume_ = false, verify_ = false, plan_ = false, explain_ = false;
  bool robust_ = false, merge_ = false;
};

}  // namespace

std::unique_ptr<Command> compare_command(CLI::App& app) { return std::make_unique<CompareCommand>(app); }

}  // namespace sim::app
