// foresight-sim check: situations as regression tests of a behaviour.
#include <chrono>
#include <cstdio>
#include <filesystem>
#include <sstream>
#include <string>
#include <thread>
#include <vector>

#include "robot/core/folder.h"
#include "robot/core/json_library.h"
#include "sim/app/commands.h"
#include "sim/app/compare_runs.h"
#include "sim/app/progress.h"
#include "sim/check/report.h"

namespace sim::app {
namespace {

constexpr auto kPause = std::chrono::milliseconds(300);  // between two looks at the files

/// The name, size and time of each file that a run reads. Another value means that a file changed.
using Files = std::vector<std::string>;

void add_file(const std::string& path, Files& files) {
  std::error_code failed;
  const auto size = std::filesystem::file_size(path, failed);
  if (failed) return;
  const auto changed = std::filesystem::last_write_time(path, failed).time_since_epoch().count();
  files.push_back(path + " " + std::to_string(size) + " " + std::to_string(changed));
}

class CheckCommand final : public Command {
 public:
  explicit CheckCommand(CLI::App& app)
      : Command(
            app.add_subcommand("check", "play situations that are tests, many times each, and judge their metrics")) {
    options()
        .add_option("folder", folder_, "folder of situations with \"check\" (sim/check/README.md), or one file")
        ->required();
    options().add_option("--home", overrides_.home, "tested behaviour, instead of that in the files");
    options().add_option("--away", overrides_.away, "behaviour of the opponents, instead of that in the files");
    options()
        .add_option("--seeds", overrides_.seeds, "number of games per situation, instead of that in the files")
        ->check(CLI::Range(2, 1'000'000));
    options().add_flag("--watch", watch_, "check again whenever a situation or a behaviour changes, until Ctrl-C");
    options().add_flag("--json", json_, "report as JSON");
    options().footer("Exit status: 0 nothing failed, 1 a metric failed, 2 bad usage or input.");
  }

  int run() override {
    if (!watch_) return run_once();
    while (true) {
      run_once();
      std::printf("\n");
      std::fflush(stdout);
      while (files() == read_) std::this_thread::sleep_for(kPause);
    }
  }

 private:
  int run_once() {
    const auto scenarios = check::load_scenarios(folder_, overrides_);
    if (scenarios) {
      behaviours_.clear();
      for (const check::Scenario& scenario : *scenarios)
        for (const std::string& name : scenario.game.strategies) behaviours_.push_back(name);
    }
    read_ = files();
    if (!scenarios) return fail(scenarios.error());
    std::vector<check::Checked> all;
    for (const check::Scenario& scenario : *scenarios) {
      ProgressBar progress("checking " + scenario.name, static_cast<std::uint64_t>(scenario.seeds));
      auto findings = check::play(scenario, [&](int done) { progress.at(static_cast<std::uint64_t>(done)); });
      if (!findings) return fail(scenario.name + ": " + findings.error());
      all.push_back({&scenario, std::move(*findings)});
    }
    std::printf("%s", json_ ? (check::to_json(all).dump(2) + "\n").c_str() : check::to_text(all).c_str());
    return check::all_passed(all) ? kDone : kNo;
  }

  /// Returns the present files: the situations, and those that the names of the behaviours contain.
  Files files() const {
    Files found;
    for (const std::string& name : behaviours_) {
      std::istringstream words(name.starts_with("pipe:") ? name.substr(5) : name.substr(0, name.find(',')));
      for (std::string word; words >> word;) add_file(word, found);
    }
    std::error_code failed;
    if (!std::filesystem::is_directory(folder_, failed)) {
      add_file(folder_, found);
    } else if (const auto entries = robot::list_folder(folder_)) {
      for (const robot::FolderEntry& entry : *entries)
        if (entry.name.ends_with(".json")) add_file((std::filesystem::path(folder_) / entry.name).string(), found);
    }
    return found;
  }

  std::string folder_;
  check::Overrides overrides_;
  std::vector<std::string> behaviours_;  // of the last situations that could be loaded
  Files read_;                           // when they were loaded
  bool watch_ = false, json_ = false;
};

}  // namespace

std::unique_ptr<Command> check_command(CLI::App& app) { return std::make_unique<CheckCommand>(app); }

}  // namespace sim::app
