// foresight-sim decisions: the decisions of a robot in a game, as CSV or as a log of Groot2.
#include <cstdio>
#include <filesystem>

#include "robot/core/files.h"
#include "sim/app/debugged_game.h"
#include "sim/check/event.h"
#include "sim/report/btlog.h"
#include "sim/report/decision_csv.h"

namespace sim::app {
namespace {

class DecisionsCommand final : public Command {
 public:
  explicit DecisionsCommand(CLI::App& app)
      : Command(
            app.add_subcommand("decisions", "write all decisions of a robot in a game: CSV, or .btlog for Groot2")) {
    game_.add_to(options());
    add_length(options(), seconds_);
    options().add_option("--robot", robot_, "robot: 14/3 or home/3, of the other side 5/3 or away/3")->required();
    options().add_option("--out", out_, "file: .csv or .btlog; without it CSV on standard output");
  }

  int run() override {
    const auto game = game_.prepare_trees();
    if (!game) return fail(game.error());
    const Params& params = game->params();
    const int robot = check::robot_named(robot_, params.rules.players, kUsualTeams);
    if (robot == kNobody)
      return fail("--robot: expected " + check::robot_names(params.rules.players, kUsualTeams) + ", got '" + robot_ +
                  "'");
    const std::string kind = std::filesystem::path(out_).extension();
    if (!out_.empty() && kind != ".csv" && kind != ".btlog")
      return fail("--out: expected a name that ends with .csv or .btlog, got '" + out_ + "'");

    const agent::TreeBehaviour& behaviour = *debug::tree_of(params, robot);
    auto text = kind == ".btlog" ? btlog_of(params, game->openings, robot, behaviour)
                                 : csv_of(params, game->openings, robot, behaviour);
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
    debug::for_each_decision(params, openings.begin(params, game_.seed()), robot, behaviour, length_of(seconds_),
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

  DebuggedGameOptions game_;
  double seconds_ = 0;
  std::string robot_, out_;
};

}  // namespace

std::unique_ptr<Command> decisions_command(CLI::App& app) { return std::make_unique<DecisionsCommand>(app); }

}  // namespace sim::app
