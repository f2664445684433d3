// foresight-sim bench: the cost of a game. Budget of a whole spl2012 game: 150 cycles per robot and tick, 12 ms.
#include <algorithm>
#include <chrono>
#include <cstdio>
#include <string>
#include <vector>

#include "robot/core/json_library.h"
#include "sim/app/commands.h"
#include "sim/app/cycles.h"
#include "sim/app/progress.h"
#include "sim/report/game_report.h"

namespace sim::app {
namespace {

constexpr std::uint64_t kFirstBenchSeed = 1;

/// The cost of one game, or the mean cost of games that were played side by side.
struct Cost {
  double ns = 0;             // computing time of the thread that played it
  double cycles_per_ns = 0;  // clock rate just before the game
  double robot_ticks = 0;
};

Cost cost_of(const contest::Lineup& lineup, std::uint64_t first_seed, int games, contest::Problem& problem) {
  const contest::Cast cast(lineup, first_seed);
  const Params& params = cast.params();
  std::vector<RandomKey> keys;
  for (int game = 0; game < games; ++game) keys.push_back({.seed = first_seed + static_cast<std::uint64_t>(game)});
  Cost cost{.cycles_per_ns = cycles_per_ns()};
  const std::uint64_t begin = computed_ns();
  const std::vector<Result> results = play_games(params, keys);
  if (cast.failed()) problem.tell(cast.problem());
  cost.ns = static_cast<double>(computed_ns() - begin) / games;
  for (const Result& result : results) cost.robot_ticks += 2.0 * params.rules.players * result.ticks / games;
  return cost;
}

std::vector<double> values_of(const std::vector<Cost>& costs, double (*value)(const Cost&)) {
  std::vector<double> values;
  for (const Cost& cost : costs) values.push_back(value(cost));
  return values;
}

class BenchCommand final : public Command {
 public:
  explicit BenchCommand(CLI::App& app)
      : Command(app.add_subcommand("bench", "measure the cost of a game on this machine")) {
    choice_.add_to(options());
    options()
        .add_option("--games", games_, "number of games, one after the other on each thread")
        ->check(CLI::Range(1, 100'000))
        ->capture_default_str();
    options()
        .add_option("--together", together_, "number of games side by side on a thread; figures are then their means")
        ->check(CLI::Range(1, 1000))
        ->capture_default_str();
    options().add_option("--threads", threads_, "number of threads")->check(CLI::Range(1, 256))->capture_default_str();
    options().add_flag("--json", json_, "report as JSON");
  }

  int run() override {
    const auto lineup = choice_.line_up();
    if (!lineup) return fail(lineup.error());
    if (together_ > 1 && (lineup->has_guest(Side::home) || lineup->has_guest(Side::away)))
      return fail("--together: expected 1 with a behaviour from outside, which plays one game, got " +
                  std::to_string(together_));
    contest::Problem problem;
    cost_of(*lineup, 0, 1, problem);  // warms the caches and the clock

    const int groups = (games_ + together_ - 1) / together_;
    std::vector<Cost> costs(static_cast<std::size_t>(groups));
    const auto begin = std::chrono::steady_clock::now();
    {
      ProgressBar progress("playing", static_cast<std::uint64_t>(games_));
      contest::for_each_game(
          groups, threads_,
          [&](int group) {
            const int first = group * together_;
            costs[static_cast<std::size_t>(group)] =
                cost_of(*lineup, kFirstBenchSeed + static_cast<std::uint64_t>(first),
                        std::min(together_, games_ - first), problem);
          },
          [&](int done) { progress.at(static_cast<std::uint64_t>(std::min(done * together_, games_))); });
    }
    const std::chrono::duration<double> seconds = std::chrono::steady_clock::now() - begin;
    if (problem.is_known()) return fail(problem.text());
    report(lineup->params(), costs, seconds.count());
    return kDone;
  }

 private:
  void report(const Params& params, const std::vector<Cost>& costs, double seconds) const {
    const auto game_ms = values_of(costs, [](const Cost& cost) { return cost.ns / 1e6; });
    const auto ns = values_of(costs, [](const Cost& cost) { return cost.ns / cost.robot_ticks; });
    const auto cycles =
        values_of(costs, [](const Cost& cost) { return cost.ns * cost.cycles_per_ns / cost.robot_ticks; });
    const auto clock = values_of(costs, [](const Cost& cost) { return cost.cycles_per_ns; });
    const io::Matchup choice = choice_.choice();
    const report::Json json = {
        {"rules", choice.rules},
        {"players", params.rules.players},
        {"home", choice.strategies[0]},
        {"away", choice.strategies[1]},
        {"home_models", params.teams[0].models.name},
        {"away_models", params.teams[1].models.name},
        {"every_tick", params.pace == Pace::every_tick},
        {"games", games_},
        {"threads", threads_},
        {"together", together_},
        {"game_ms", {{"median", contest::median_of(game_ms)}, {"mean", contest::mean_of(game_ms).mean}}},
        {"robot_tick_ns", contest::median_of(ns)},
        {"robot_tick_cycles", contest::median_of(cycles)},
        {"clock_ghz", contest::median_of(clock)},
        {"games_per_second", games_ / seconds}};
    if (json_) {
      std::printf("%s\n", json.dump(2).c_str());
      return;
    }
    std::printf("%s, %d a side, %s against %s, %d games on %d thread%s\n", choice.rules.c_str(), params.rules.players,
                choice.strategies[0].c_str(), choice.strategies[1].c_str(), games_, threads_, threads_ > 1 ? "s" : "");
    std::printf("  game             %8.2f ms median, %.2f ms mean, as the thread computed\n",
                contest::median_of(game_ms), contest::mean_of(game_ms).mean);
    std::printf("  robot and tick   %8.1f ns, %.0f cycles at %.2f GHz\n", contest::median_of(ns),
                contest::median_of(cycles), contest::median_of(clock));
    std::printf("  games            %8.1f a second, by the clock on the wall\n", games_ / seconds);
  }

  ChoiceOptions choice_;
  int games_ = 200, threads_ = 1, together_ = 1;
  bool json_ = false;
};

}  // namespace

std::unique_ptr<Command> bench_command(CLI::App& app) { return std::make_unique<BenchCommand>(app); }

}  // namespace sim::app
