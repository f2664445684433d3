// foresight-sim decisions: the decisions of a robot in a game, as CSV or as a log of Groot2.
#include <cstdio>
#include <filesystem>

#include "robot/core/files.h"
#include "sim/app/commands.h"
#include "sim/check/event.h"
#include "sim/contest/openings.h"
#include "sim/debug/setup.h"
#include "sim/report/btlog.h"
#include "sim/report/decision_csv.h"

namespace sim::app {
namespace {

constexpr io::SituationTeams kTeams{.home = 14, .away = 5};

class DecisionsCommand final : public Command {
 public:
  explicit DecisionsCommand(CLI::App& app)
      : Command(
            app.add_subcommand("decisions", "write all decisions of a robot in a game: CSV, or .btlog for Groot2")) {
    choice_.add_to(options());
    options()
        .add_option("--seed", seed_, "seed of the game")
        ->check(CLI::Range(std::uint64_t{0}, kMostSeed))
        ->capture_default_str();
    options().add_option("--from", from_, "start of the game: name or file of a described moment");
    options().add_option("--seconds", seconds_, "[s] length of the game; 0: to its end")->check(CLI::Range(0., 36000.));
    options().add_option("--robot", robot_, "robot: 14/3 or home/3, of the other side 5/3 or away/3")->required();
    options().add_option("--out", out_, "file: .csv or .btlog; without it CSV on standard output");
  }

  int run() override {
    const auto setup = debug::prepare(choice_.lineup_choice());
    if (!setup) return fail(setup.error());
    const Params& params = (*setup)->params;
    const auto openings = contest::Openings::read(from_, false, params);
    if (!openings) return fail(openings.error());
    const int robot = check::robot_named(robot_, params.rules.players, kTeams);
    if (robot == kNobody)
      return fail("--robot: expected " + check::robot_names(params.rules.players, kTeams) + ", got '" + robot_ + "'");
    const std::string kind = std::filesystem::path(out_).extension();
    if (!out_.empty() && kind != ".csv" && kind != ".btlog")
      return fail("--out: expected a name that ends with .csv or .btlog, got '" + out_ + "'");

    const agent::TreeBehaviour& behaviour = *debug::tree_of(params, robot);
    auto text =
        kind == ".btlog" ? btlog_of(params, *openings, robot, behaviour) : csv_of(params, *openings, robot, behaviour);
    if (!text) return fail(text.error());
    if (out_.empty()) {
      std::fputs(text->c_str(), stdout);
      return kDone;
    }
    if (const auto written = robot::replace_file(out_, *text); !written) return fail(written.error());
    return kDone;
  }

 private:
  template <class See>
  void play(const Params& params, const contest::Openings& openings, int robot, const agent::TreeBehaviour& behaviour,
            See&& see) const {
    const Tick most = seconds_ > 0 ? ticks(static_cast<float>(seconds_)) : kNever;
    debug::for_each_decision(params, openings.begin(params, seed_), robot, behaviour, most,
                             [&](const debug::LoggedDecision& logged, const State&) { see(logged); });
  }

  robot::Result<std::string> csv_of(const Params& params, const contest::Openings& openings, int robot,
                                    const agent::TreeBehaviour& behaviour) const {
    std::string text = report::csv_head(behaviour.tree());
    play(params, openings, robot, behaviour,
         [&](const debug::LoggedDecision& logged) { text += report::csv_row(behaviour.tree(), logged); });
    return text;
  }

  robot::Result<std::string> btlog_of(const Params& params, const contest::Openings& openings, int robot,
                                      const agent::TreeBehaviour& behaviour) const {
    auto log = report::BtLog::of(behaviour.tree());
    if (!log) return log.failure();
    play(params, openings, robot, behaviour, [&](const debug::LoggedDecision& logged) {
      if (logged.evaluation)
        log->decided(logged.decision.tick, *logged.evaluation);
      else
        log->rests(logged.decision.tick);
    });
    return log->bytes();
  }

  ChoiceOptions choice_;
  std::uint64_t seed_ = 1;
  double seconds_ = 0;
  std::string from_, robot_, out_;
};

}  // namespace

std::unique_ptr<Command> decisions_command(CLI::App& app) { return std::make_unique<DecisionsCommand>(app); }

}  // namespace sim::app
