// foresight-lab game-statistics: figures of recorded games beside those of real ones.
#include <cstdio>

#include "robot/app/game_windows.h"
#include "robot/app/lab/commands.h"
#include "robot/core/files.h"
#include "robot/core/json_library.h"
#include "sim/report/realism.h"

namespace robot::app {
namespace {

class GameStatisticsCommand final : public Command {
 public:
  explicit GameStatisticsCommand(CLI::App& app)
      : Command(app.add_subcommand("game-statistics", "kicks, walking, crowding: recorded games beside real ones")) {
    options().add_option("sessions", sessions_, "folders of sessions with /truth/world, or .mcap files")->required();
    options().add_option("--real", real_, "the real games: a name or a file")->capture_default_str();
    options().add_option("--html", html_, "file for an HTML page");
    options().add_flag("--json", json_, "report as JSON");
  }

  int run() override {
    const auto real = sim::io::load_real_games(real_);
    if (!real) return fail(real.error());
    std::vector<sim::statistics::Figures> figures;
    for (const std::string& path : sessions_) {
      const auto session = logging::open_session(path);
      if (!session) return fail(session.error());
      const auto windows = windows_of(*session);
      if (!windows) return fail(windows.error());
      for (const sim::statistics::Window& window : *windows) figures.push_back(sim::statistics::measure(window));
    }
    const sim::report::Realism realism = sim::report::realism_of(figures, *real, "recorded");
    if (!html_.empty()) {
      const std::string about = std::to_string(sessions_.size()) + " recorded sessions.";
      if (const auto written = replace_file(html_, sim::report::page_of(realism, about)); !written)
        return fail(written.error());
    }
    if (json_)
      std::printf("%s\n", sim::report::to_json(realism).dump(2).c_str());
    else
      std::fputs(sim::report::to_text(realism).c_str(), stdout);
    return kDone;
  }

 private:
  std::vector<std::string> sessions_;
  std::string real_ = sim::io::kNewestRealGames, html_;
  bool json_ = false;
};

}  // namespace

std::unique_ptr<Command> game_statistics_command(CLI::App& app) { return std::make_unique<GameStatisticsCommand>(app); }

}  // namespace robot::app
