// foresight-sim learn: a tree goes in, a better tree comes out, and a test says whether it is better.
#include <cstdio>
#include <filesystem>
#include <memory>
#include <system_error>

#include "robot/core/files.h"
#include "robot/core/json_library.h"
#include "robot/core/text.h"
#include "sim/app/commands.h"
#include "sim/app/progress.h"
#include "sim/contest/series.h"
#include "sim/contest/slurm.h"
#include "sim/io/json.h"
#include "sim/learn/learning.h"
#include "sim/report/learn_page.h"

namespace sim::app {
namespace {

constexpr int kNotBetter = 1;

class LearnCommand final : public Command {
 public:
  explicit LearnCommand(CLI::App& app)
      : Command(app.add_subcommand("learn", "improve a decision tree layer by layer, and prove it")) {
    choice_.layers = {"follow", "kick", "pass", "role"};
    choice_.world.opponents = {"baseline", "high_line"}, choice_.unseen = {"align_first", "passing"};
    options().add_option("strategy", choice_.strategy, "name or file of the tree to begin with")->required();
    options()
        .add_option("--layers", choice_.layers, "names or files of layers, from the lowest on, behind commas")
        ->delimiter(',')
        ->capture_default_str();
    options()
        .add_option("--budget", budget_,
                    "minutes that two cores of a laptop have for practice: 10m; the gate comes on top")
        ->capture_default_str();
    options().add_option("--out", out_, "file for the learned tree");
    options().add_option("--html", html_, "file for an HTML page with the learning curves");
    options().add_option("--from", choice_.folder, "folder of the run: begin it there, or go on after a kill");
    options()
        .add_option("--seed", choice_.seed, "seed of the run; the same seed gives the same tree")
        ->check(CLI::Range(std::uint64_t{0}, learn::Seeds::kMostRun))
        ->capture_default_str();
    options()
        .add_option("--opponents", choice_.world.opponents, "opponents of whole games, behind commas")
        ->delimiter(',')
        ->capture_default_str();
    options()
        .add_option("--unseen", choice_.unseen,
                    "opponents that only the gate plays, behind commas; the tree may not be worse")
        ->delimiter(',')
        ->capture_default_str();
    options().add_option("--rules", choice_.world.rules, "rules of whole games")->capture_default_str();
    options().add_option("--models", choice_.world.models, "models of whole games")->capture_default_str();
    options().add_flag("--robust", choice_.world.robust, "practise with other walks, kicks and ball noise, too");
    options()
        .add_option("--wanted", choice_.wanted, "[goals a game] gain that the gate must distinguish from none")
        ->check(CLI::Range(0.01, 10.))
        ->capture_default_str();
    options()
        .add_option("--most-pairs", choice_.most_pairs, "longest sequential test of the gate")
        ->check(CLI::Range(50, 1'000'000))
        ->capture_default_str();
    options()
        .add_option("--threads", choice_.world.threads, "default: one per processor; the tree is the same")
        ->check(CLI::Range(1, 256));
    options().add_option("--share", share_,
                         "K/N: this process is number K, from 0 on, of N that play the run in --from together");
    options()
        .add_option("--engine", engine_, "this machine (local), or --tasks jobs of a cluster (slurm)")
        ->check(CLI::IsMember({"local", "slurm"}))
        ->capture_default_str();
    options()
        .add_option("--tasks", tasks_, "number of a cluster's jobs")
        ->check(CLI::Range(1, contest::kMostTasks))
        ->capture_default_str();
    options().add_flag("--control", choice_.shuffled, "deal the rewards by chance: nothing may be learned");
    options().add_flag("--json", json_, "report as JSON");
    options().footer("Exit status: 0 the learned tree is better, 1 it is not, 2 bad usage or input.");
    choice_.world.threads = contest::threads_for(1 << 20);
  }

  int run() override {
    if (const std::string wrong = read_words(); !wrong.empty()) return fail(wrong);
    if (engine_ == "slurm") return hand_to_cluster();
    const auto course = [&] {
      std::unique_ptr<ProgressBar> bar;
      std::string shown;
      return learn::learn(choice_, [&](const std::string& activity, double done) {
        if (activity != shown) bar = std::make_unique<ProgressBar>(shown = activity, 1000);
        bar->at(static_cast<std::uint64_t>(1000 * done));
      });
    }();
    if (!course) return fail(course.error());
    if (!choice_.share.is_first()) return kDone;  // the first process reports
    // first of all: a file that cannot be written must not cost the answer
    std::fputs(json_ ? (report::learn_json(*course).dump(2) + "\n").c_str() : report::learn_text(*course).c_str(),
               stdout);
    if (!out_.empty())
      if (const auto written = robot::replace_file(out_, io::printed(course->learned) + "\n"); !written)
        return fail(written.error());
    if (!html_.empty())
      if (const auto written = robot::replace_file(html_, report::learn_page(*course)); !written)
        return fail(written.error());
    return course->better ? kDone : kNotBetter;
  }

 private:
  std::string read_words() {
    for (auto* const names : {&choice_.layers, &choice_.world.opponents, &choice_.unseen}) std::erase(*names, "");
    if (choice_.layers.empty()) return "--layers must name at least one layer";
    if (choice_.world.opponents.empty()) return "--opponents must name at least one behaviour";
    int used = 0;
    char unit = 'm';
    const int read = std::sscanf(budget_.c_str(), "%lf%n%c%n", &choice_.minutes, &used, &unit, &used);
    const bool good =
        read >= 1 && used == static_cast<int>(budget_.size()) && (unit == 'm' || unit == 's' || unit == 'h');
    if (unit == 's') choice_.minutes /= 60;
    if (unit == 'h') choice_.minutes *= 60;
    if (!good || !(choice_.minutes > 0 && choice_.minutes <= 6000))
      return "--budget must be a time such as 90s, 10m or 2h, at most 100h, got '" + budget_ + "'";
    if (std::string wrong = read_share(); !wrong.empty()) return wrong;
    choice_.name = out_.empty() ? "learned" : std::filesystem::path(out_).stem().string();
    return "";
  }

  std::string read_share() {
    if (engine_ == "slurm" && (choice_.folder.empty() || out_.empty() || !share_.empty()))
      return "--engine slurm needs --out, and --from, a folder that all machines of the cluster see; it sets --share";
    if (share_.empty()) return "";
    auto& [number, of] = choice_.share;
    int used = 0;
    const int read = std::sscanf(share_.c_str(), "%d/%d%n", &number, &of, &used);
    if (read != 2 || used != static_cast<int>(share_.size()) || number < 0 || number >= of || of > contest::kMostTasks)
      return robot::formatted("--share must be K/N with 0 <= K < N <= %d, got '%s'", contest::kMostTasks,
                              share_.c_str());
    return choice_.folder.empty() ? "--share needs --from, the folder of the run" : "";
  }

  int hand_to_cluster() {
    std::error_code failed;
    std::filesystem::create_directories(choice_.folder, failed);
    if (failed) return fail("run " + choice_.folder.string() + ": " + failed.message());
    const std::vector<std::string> words = words_again(options(), {"--engine", "--tasks"});
    const auto job = contest::submit_script(choice_.folder, "learn", contest::sharing_script(words, tasks_));
    if (!job) return fail(job.error());
    std::printf("job %s: %d tasks share the run in %s; the first one writes %s\n", job->c_str(), tasks_,
                choice_.folder.c_str(), out_.c_str());
    return kDone;
  }

  learn::LearnChoice choice_;
  std::string budget_ = "10m", out_, html_, share_, engine_ = "local";
  int tasks_ = 8;
  bool json_ = false;
};

}  // namespace

std::unique_ptr<Command> learn_command(CLI::App& app) { return std::make_unique<LearnCommand>(app); }

}  // namespace sim::app
