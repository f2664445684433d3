#include "sim/app/match_statistics.h"

#include <cstdio>
#include <memory>
#include <vector>

#include "robot/core/files.h"
#include "robot/core/json_library.h"
#include "sim/app/commands.h"
#include "sim/app/played_game.h"
#include "sim/app/progress.h"
#include "sim/contest/lineup_series.h"
#include "sim/contest/repetition.h"
#include "sim/match/hash.h"
#include "sim/report/film.h"
#include "sim/report/realism.h"

namespace sim::app {
namespace {

/// The figures of a game's windows, and the hash of the game.
struct MeasuredGame {
  std::vector<statistics::Figures> figures;
  std::uint64_t hash = 0;
};

/// A game that is filmed.
class FilmedGame {
 public:
  State state;

  FilmedGame(const State& start, float seconds) : state(start), end_(end_of(state, seconds)) {}

  bool goes_on() {
    film_.look(state);
    return state.world.tick < end_;
  }
  void see(const referee::Events&) {}
  MeasuredGame measured() const {
    MeasuredGame measured{.hash = hash_of_game(state)};
    for (const statistics::Window& window : film_.windows()) measured.figures.push_back(statistics::measure(window));
    return measured;
  }

 private:
  report::Film film_;
  const Tick end_;
};

/// Returns the figures of all complete windows of all games, in the order of the seeds.
robot::Result<std::vector<statistics::Figures>> measure_games(const StatisticsTask& task, const contest::Lineup& lineup,
                                                              const contest::Openings& openings) {
  std::vector<MeasuredGame> games(static_cast<std::size_t>(task.games));
  ProgressBar progress("measuring", static_cast<std::uint64_t>(task.games));
  const auto played = contest::play_series(
      lineup, {.first_seed = task.seed, .games = task.games, .threads = task.threads},
      [&](int, std::uint64_t seed, const contest::Cast& cast) {
        return std::make_unique<FilmedGame>(openings.begin(cast.params(), seed), task.seconds);
      },
      [&](int game, const FilmedGame& ended, const contest::Cast&) {
        games[static_cast<std::size_t>(game)] = ended.measured();
      },
      [&](int done) { progress.at(static_cast<std::uint64_t>(done)); });
  if (!played) return played.failure();

  std::vector<std::uint64_t> hashes;
  std::vector<statistics::Figures> windows;
  for (const MeasuredGame& game : games) {
    hashes.push_back(game.hash);
    windows.insert(windows.end(), game.figures.begin(), game.figures.end());
  }
  warn_of_repetition(task.games, contest::different_games(std::move(hashes)), task.choice);
  if (windows.empty())
    return robot::Error{"--statistics needs a game with at least 167 s in play; play more or longer games"};
  return windows;
}

}  // namespace

int run_statistics(const StatisticsTask& task, const contest::Lineup& lineup, const contest::Openings& openings) {
  const auto real = io::load_real_games(task.real);
  if (!real) return fail(real.error());
  const auto windows = measure_games(task, lineup, openings);
  if (!windows) return fail(windows.error());
  const report::Realism realism = report::realism_of(*windows, *real, "simulated");
  if (!task.html.empty()) {
    const std::string about = std::to_string(task.games) + " simulated games.";
    if (const auto written = robot::replace_file(task.html, report::page_of(realism, about)); !written)
      return fail(written.error());
  }
  if (task.json)
    std::printf("%s\n", report::to_json(realism).dump(2).c_str());
  else
    std::fputs(report::to_text(realism).c_str(), stdout);
  return kDone;
}

}  // namespace sim::app
