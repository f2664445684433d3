// foresight-sim coverage: what each part of a decision tree does over many games.
#include <cstdio>
#include <mutex>

#include "robot/core/files.h"
#include "robot/core/json_library.h"
#include "sim/app/debugged_game.h"
#include "sim/app/progress.h"
#include "sim/contest/repetition.h"
#include "sim/contest/series.h"
#include "sim/match/hash.h"
#include "sim/report/coverage_report.h"

namespace sim::app {
namespace {

class CoverageCommand final : public Command {
 public:
  explicit CoverageCommand(CLI::App& app)
      : Command(app.add_subcommand(
            "coverage",
            "how often each part of a tree runs over many games, what follows, and what is never reached")) {
    game_.add_to(options());
    options().add_option("--games", games_, "number of games")->check(CLI::Range(1, 1'000'000))->capture_default_str();
    options()
        .add_option("--side", side_, "watch the tree of this side's player 1")
        ->check(CLI::IsMember({"home", "away"}))
        ->capture_default_str();
    add_length(options(), seconds_);
    options()
        .add_option("--threads", threads_, "games at a time; 0: one for each processor")
        ->check(CLI::Range(0, 1024))
        ->capture_default_str();
    options().add_option("--html", html_, "also write a page: the tree as a heat map");
    options().add_flag("--json", json_, "report as JSON");
  }

  int run() override {
    const auto game = game_.prepare_trees();
    if (!game) return fail(game.error());
    const Params& params = game->params();
    const Side side = side_ == "home" ? Side::home : Side::away;
    const agent::TreeBehaviour& behaviour = *debug::tree_of(params, side == Side::home ? 0 : kMaxPlayers);
    const debug::Parts parts(behaviour.tree());

    const debug::Coverage coverage = watch(params, game->openings, side, parts);
    if (coverage.parts.front().decisions == 0) return fail("no robot decided in play; play more or longer games");
    const io::Matchup choice = game_.choice();
    const report::CoverageReport report{.parts = parts,
                                        .coverage = coverage,
                                        .about = "of the " + side_ + " side against " +
                                                 choice.strategies[side == Side::home ? 1 : 0] + ", " +
                                                 std::to_string(games_) + (games_ == 1 ? " game" : " games") +
                                                 " from seed " + std::to_string(game_.seed())};
    if (!html_.empty())
      if (const auto written = robot::replace_file(html_, report::page_of(report)); !written)
        return fail(written.error());
    if (json_)
      std::printf("%s\n", report::to_json(report).dump(2).c_str());
    else
      std::fputs(report::to_text(report).c_str(), stdout);
    return kDone;
  }

 private:
  debug::Coverage watch(const Params& params, const contest::Openings& openings, Side side, const debug::Parts& parts) {
    std::vector<std::uint64_t> hashes(static_cast<std::size_t>(games_));
    debug::Coverage sum;
    std::mutex lock;
    ProgressBar progress("watching", static_cast<std::uint64_t>(games_));
    contest::for_each_game(
        games_, threads_ > 0 ? threads_ : contest::threads_for(games_),
        [&](int game) {
          State state = openings.begin(params, game_.seed() + static_cast<std::uint64_t>(game));
          const debug::Coverage seen = watch_game(params, state, side, parts, length_of(seconds_));
          hashes[static_cast<std::size_t>(game)] = hash_of_game(state);
          const std::lock_guard locked(lock);
          sum.add(seen);
        },
        [&](int done) { progress.at(static_cast<std::uint64_t>(done)); });
    warn_of_repetition(games_, contest::different_games(std::move(hashes)), game_.choice());
    return sum;
  }

  DebuggedGameOptions game_;
  int games_ = 100, threads_ = 0;
  double seconds_ = 0;
  std::string side_ = "home", html_;
  bool json_ = false;
};

}  // namespace

std::unique_ptr<Command> coverage_command(CLI::App& app) { return std::make_unique<CoverageCommand>(app); }

}  // namespace sim::app
