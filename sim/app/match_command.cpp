// foresight-sim match: a game, or a series of them.
#include <cstdio>
#include <functional>
#include <memory>
#include <optional>

#include "robot/core/files.h"
#include "robot/core/json_library.h"
#include "sim/app/commands.h"
#include "sim/app/match_statistics.h"
#include "sim/app/played_game.h"
#include "sim/app/progress.h"
#include "sim/contest/lineup_series.h"
#include "sim/contest/openings.h"
#include "sim/contest/repetition.h"
#include "sim/io/json.h"
#include "sim/io/real_games.h"
#include "sim/io/saved_moment.h"
#include "sim/match/hash.h"
#include "sim/report/game_line.h"
#include "sim/report/game_report.h"

namespace sim::app {
namespace {

constexpr int kMostGames = 1'000'000;

class MatchCommand final : public Command {
 public:
  explicit MatchCommand(CLI::App& app) : Command(app.add_subcommand("match", "play a game, or several")) {
    choice_.add_to(options());
    options()
        .add_option("--seed", seed_, "seed of all random numbers; of several games, that of the first")
        ->check(CLI::Range(std::uint64_t{0}, kMostSeed))
        ->capture_default_str();
    options()
        .add_option("--games", games_, "number of games, with consecutive seeds")
        ->check(CLI::Range(1, kMostGames))
        ->capture_default_str();
    options()
        .add_option("--threads", threads_, "number of games at once; 0: one per processor")
        ->check(CLI::Range(0, 256))
        ->capture_default_str();
    options().add_option("--from", from_,
                         "start of the game: name or file of a described moment, or a folder of moments, used in turn");
    options().add_flag("--fuzz", fuzz_, "with --from: begins with slightly shifted robots and ball");
    options().add_option("--seconds", seconds_, "[s] longest game, dead time included")->check(CLI::Range(1., 36000.));
    options().add_flag("--shoot-out", shoot_out_, "a drawn game is decided by a penalty shoot-out, by the rules");
    options().add_flag("--json", json_, "report as JSON");
    options().add_flag("--lines", lines_, "print a line of JSON per game, with the errors of the robots' beliefs");
    options().add_flag("--statistics", statistics_, "print figures of the games beside those of real games");
    options().add_option("--html", html_, "with --statistics: file for an HTML page");
    options().add_option("--real", real_, "with --statistics: the real games, a name or a file")->capture_default_str();
    options().add_option(
        "--mcap", mcap_,
        "new file for a recording of the game, without a penalty shoot-out: truth, beliefs and decisions");
    options()
        .add_option(
            "--save-at", save_at_,
            "moment and file: saves that moment of the game as a situation. The moment is in [s] since the first "
            "tick, dead time included, or half:minutes:seconds on the clock such as 2:05:12. A situation holds "
            "ball, robots, score and clock, not what the robots believe, remember and do")
        ->expected(2)
        ->type_name("MOMENT FILE");
    options()
        .add_option("--home-team", teams_.home, "team number in the recording")
        ->check(CLI::Range(1, 999))
        ->capture_default_str();
    options()
        .add_option("--away-team", teams_.away, "team number in the recording")
        ->check(CLI::Range(1, 999))
        ->capture_default_str();
  }

  int run() override {
    if (!mcap_.empty() && lines_) return fail("--mcap and --lines do not go together");
    if (!mcap_.empty() && games_ > 1) return fail("--mcap records one game, got --games " + std::to_string(games_));
    if (!save_at_.empty() && (lines_ || statistics_ || games_ > 1))
      return fail("--save-at is of one game, without --lines, --statistics and --games");
    if (fuzz_ && from_.empty()) return fail("--fuzz needs --from, the situation that is varied");
    if (teams_.home == teams_.away)
      return fail("the teams must have different numbers, got " + std::to_string(teams_.home) + " twice");
    if (lines_ && !from_.empty()) return fail("--lines and --from do not go together");
    if (lines_ && seconds_ > 0) return fail("--lines and --seconds do not go together");
    if (statistics_ && (lines_ || !mcap_.empty())) return fail("--statistics goes with neither --lines nor --mcap");
    if (!statistics_ && !html_.empty()) return fail("--html needs --statistics, whose table it draws");
    const auto lineup = choice_.line_up();
    if (!lineup) return fail(lineup.error());
    if (const field::Rules& rules = lineup->params().rules; shoot_out_ && (!has_shoot_out(rules) || rules.players < 2))
      return fail("--shoot-out needs rules with a penalty shoot-out and two players a side, got " +
                  choice_.choice().rules + " with " + std::to_string(rules.players));
    const auto openings = contest::Openings::read(from_, fuzz_, lineup->params());
    if (!openings) return fail(openings.error());
    if (statistics_)
      return run_statistics({.seed = seed_,
                             .games = games_,
                             .threads = threads_,
                             .seconds = seconds_,
                             .real = real_,
                             .html = html_,
                             .json = json_,
                             .choice = choice_.choice()},
                            *lineup, *openings);
    if (lines_) return run_lines(*lineup);
    return games_ > 1 ? run_many(*lineup, *openings) : run_one(*lineup, *openings);
  }

 private:
  int run_one(const contest::Lineup& lineup, const contest::Openings& openings) {
    const contest::Cast cast(lineup, seed_);
    const Params& params = cast.params();
    std::optional<Recording> recording;
    auto moment = io::SavedMoment::parse(save_at_.empty() ? "0" : save_at_[0]);
    if (!moment) return fail("--save-at: " + moment.error());
    const std::string about = save_at_.empty() ? "" : origin();
    if (!mcap_.empty()) recording = {.path = mcap_, .names = {.rules = choice_.choice().rules, .teams = teams_}};
    const auto report = [&] {
      ProgressBar progress("recording", recording ? expected_ticks(params.rules) : 0);
      return play_one(cast, openings, wish(seed_), recording ? &*recording : nullptr, &progress,
                      [&](const State& state) {
                        if (!save_at_.empty()) moment->see(state, about);
                      });
    }();
    if (!report) return fail(report.error());
    if (const auto saved = save(*moment, report->result); !saved) return fail(saved.error());
    if (json_)
      std::printf("%s\n", report::to_json(*report, params.rules.players).dump(2).c_str());
    else
      std::printf("%s%s", report::to_text(*report, choice_.choice(), params).c_str(),
                  contest::cost_text(cast.cost(Side::home), cast.cost(Side::away)).c_str());
    if (recording && !json_)
      std::printf("\n%s: %llu messages, %.1f MB%s\n", mcap_.c_str(),
                  static_cast<unsigned long long>(recording->messages),
                  static_cast<double>(recording->size_bytes) / 1e6,
                  report->shoot_out ? "; it ends with the game, before the penalty shoot-out" : "");
    return kDone;
  }

  GameWish wish(std::uint64_t seed) const { return {.seed = seed, .seconds = seconds_, .shoot_out = shoot_out_}; }

  /// Returns the text that tells from which game a saved moment comes.
  std::string origin() const {
    const io::Matchup choice = choice_.choice();
    return choice.strategies[0] + " against " + choice.strategies[1] + ", " + choice.rules + ", seed " +
           std::to_string(seed_) + ", moment " + save_at_[0];
  }

  /// Writes the file of --save-at.
  robot::Result<void> save(const io::SavedMoment& moment, const sim::Result& result) const {
    if (save_at_.empty()) return {};
    if (!moment.reached())
      return robot::Error{"--save-at: expected a moment before the end of the game, which is " +
                          io::short_text(static_cast<float>(result.ticks) * kTickDuration) +
                          " s after the first tick, got " + save_at_[0]};
    return robot::replace_file(save_at_[1], moment.text());
  }

  int run_many(const contest::Lineup& lineup, const contest::Openings& openings) {
    std::vector<report::GameReport> reports(static_cast<std::size_t>(games_));
    contest::Costs costs;
    const auto played = play_all(
        lineup, &costs,
        [&](int, std::uint64_t seed, const contest::Cast& cast) {
          return std::make_unique<NotedGame>(cast, openings, wish(seed));
        },
        [&](int game, NotedGame& ended, const contest::Cast&) {
          report::GameReport& report = reports[static_cast<std::size_t>(game)];
          report = ended.report();
          report.decisions.clear();
        });
    if (!played) return fail(played.error());
    warn_of_repetition(games_, report::different_games(reports), choice_.choice());
    if (json_)
      std::printf("%s\n", report::to_json(reports, lineup.params().rules.players).dump(2).c_str());
    else
      std::printf("%s%s", report::to_text(reports, choice_.choice(), lineup.params()).c_str(), costs.text().c_str());
    return kDone;
  }

  int run_lines(const contest::Lineup& lineup) {
    std::vector<report::GameLine> lines(static_cast<std::size_t>(games_));
    const auto played = play_all(
        lineup, nullptr,
        [](int, std::uint64_t seed, const contest::Cast& cast) {
          return std::make_unique<report::LineGame>(cast.params(), seed);
        },
        [&](int game, const report::LineGame& ended, const contest::Cast& cast) {
          lines[static_cast<std::size_t>(game)] = ended.line(cast.params(), shoot_out_);
        });
    if (!played) return fail(played.error());
    std::vector<std::uint64_t> hashes;
    for (const report::GameLine& line : lines) hashes.push_back(line.hash);
    warn_of_repetition(games_, contest::different_games(std::move(hashes)), choice_.choice());
    for (const report::GameLine& line : lines) std::fputs(line.text.c_str(), stdout);
    return kDone;
  }

  /// Plays all games (sim/contest/lineup_series.h).
  robot::Result<void> play_all(const contest::Lineup& lineup, contest::Costs* costs, auto&& begin, auto&& end) const {
    ProgressBar progress("playing", static_cast<std::uint64_t>(games_));
    const contest::Series series{.first_seed = seed_, .games = games_, .threads = threads_, .costs = costs};
    return contest::play_series(lineup, series, begin, end,
                                [&](int done) { progress.at(static_cast<std::uint64_t>(done)); });
  }

  ChoiceOptions choice_;
  std::uint64_t seed_ = 1;
  int games_ = 1, threads_ = 0;
  float seconds_ = 0;
  bool json_ = false, lines_ = false, fuzz_ = false, shoot_out_ = false, statistics_ = false;
  std::string mcap_, from_, html_, real_ = io::kNewestRealGames;
  std::vector<std::string> save_at_;  // moment and file, or empty
  robot::bridge::TeamNumbers teams_;
};

}  // namespace

std::unique_ptr<Command> match_command(CLI::App& app) { return std::make_unique<MatchCommand>(app); }

}  // namespace sim::app
