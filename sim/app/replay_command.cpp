// foresight-sim replay: one side of a recorded game moves as recorded, the other plays with a strategy.
#include <cstdio>
#include <optional>

#include "robot/core/json_library.h"
#include "sim/app/commands.h"
#include "sim/app/game_file.h"
#include "sim/app/recorded_game.h"
#include "sim/io/json.h"
#include "sim/match/hash.h"
#include "sim/match/step.h"
#include "sim/report/game_report.h"

namespace sim::app {
namespace {

using Kind = referee::Event::Kind;

constexpr int kMostGames = 10'000;

/// A replay that was played.
struct ReplayedGame {
  report::GameReport report;
  replay::Replay replay;
};

bool is_about(const referee::Event& event, const replay::Replay& replay) {
  return event.robot != kNobody && replay.is_recorded(event.robot);
}

class ReplayCommand final : public Command {
 public:
  explicit ReplayCommand(CLI::App& app)
      : Command(app.add_subcommand("replay", "one side of a recorded game moves as recorded, the other plays")) {
    options().add_option("session", session_, "folder of a session with /truth/world, or an .mcap file")->required();
    options()
        .add_option("--side", side_, "side that moves as recorded: home, away or both")
        ->check(CLI::IsMember({"home", "away", "both"}))
        ->capture_default_str();
    options()
        .add_option("--strategy", strategy_, "behaviour of the other side: name, file, library or pipe:command")
        ->capture_default_str();
    options()
        .add_option("--from", from_, "[s] start, since the recording's first ground truth")
        ->check(CLI::Range(0., 36000.))
        ->capture_default_str();
    options()
        .add_option("--seconds", seconds_, "[s] length; it ends earlier with the recording or with a goal")
        ->check(CLI::Range(0.1, 3600.))
        ->capture_default_str();
    options().add_option("--rules", rules_, "rules of a year; default: those of the recorded simulation, else spl2025");
    options().add_option("--models", models_, "models of the robots")->capture_default_str();
    options()
        .add_option("--seed", seed_, "seed of all random numbers; of several games, that of the first")
        ->check(CLI::Range(std::uint64_t{0}, std::uint64_t{1} << 53))
        ->capture_default_str();
    options()
        .add_option("--games", games_, "number of replays, with consecutive seeds")
        ->check(CLI::Range(1, kMostGames))
        ->capture_default_str();
    options().add_option("--home-team", wanted_.home, "team number of the home side; default: by the recording");
    options().add_option("--away-team", wanted_.away, "team number of the away side; default: by the recording");
    options().add_flag("--json", json_, "report as JSON");
    options().add_flag("--lines", lines_, "print a line of JSON per replay");
    options().add_option("--mcap", mcap_, "new file for a recording of the replay");
  }

  int run() override {
    if (!mcap_.empty() && (lines_ || games_ > 1)) return fail("--mcap records one replay, without --lines and --games");
    if (lines_ && json_) return fail("--lines and --json do not go together");
    const auto session = robot::logging::open_session(session_);
    if (!session) return fail(session.error());
    choice_ = choose(*session);
    const auto lineup = contest::Lineup::prepare({.game = choice_, .rest = {}});
    if (!lineup) return fail(lineup.error());
    const auto game = read_recorded_game(*session, lineup->params().rules.players, wanted_);
    if (!game) return fail(game.error());
    if (const auto problem = refuse(*game); !problem.empty()) return fail(problem);

    std::vector<report::GameReport> reports;
    for (int i = 0; i < games_; ++i) {
      auto played = play(*lineup, *game, seed_ + static_cast<std::uint64_t>(i));
      if (!played) return fail(played.error());
      if (lines_) std::printf("%s\n", line_of(*played, *game, lineup->params()).dump().c_str());
      if (games_ == 1 && !lines_) print(*played, *game, lineup->params());
      played->report.decisions.clear();
      reports.push_back(std::move(played->report));
    }
    if (games_ > 1) warn_of_repetition(games_, report::different_games(reports), choice_);
    if (games_ > 1 && !lines_) print(reports, lineup->params());
    return kDone;
  }

 private:
  std::array<bool, 2> recorded() const { return {side_ != "away", side_ != "home"}; }

  io::Matchup choose(const robot::logging::Session& session) const {
    io::Matchup choice;
    choice.rules = rules_.empty() ? recorded_rules(session) : rules_;
    if (choice.rules.empty()) choice.rules = "spl2025";
    for (const int side : {0, 1}) {
      choice.models[side] = models_;
      choice.strategies[side] = recorded()[static_cast<std::size_t>(side)] ? "idle" : strategy_;
    }
    return choice;
  }

  /// Returns the reason why the recording has nothing to replay from that moment, or an empty text.
  std::string refuse(const RecordedGame& game) const {
    const replay::Recording& recording = game.recording;
    const Tick from = ticks(from_);
    const std::string moment = io::short_text(from_) + " s";
    if (from >= recording.length)
      return "--from: expected a moment before the end of " + session_ + ", which is " +
             io::short_text(static_cast<float>(recording.length) / kTicksPerSecond) + " s after its start, got " +
             moment;
    if (!recording.ball.at(from)) return session_ + " has no ball at " + moment + "; choose another --from";
    for (const Side side : {Side::home, Side::away}) {
      bool any = false;
      for (int player = 1; player <= kMaxPlayers; ++player)
        any = any || recording.robots[static_cast<std::size_t>(robot_of(side, player))].at(from);
      if (!any)
        return session_ + " has no robot of team " + std::to_string(game.teams.of(side)) + " at " + moment +
               "; choose another --from";
    }
    return {};
  }

  robot::Result<ReplayedGame> play(const contest::Lineup& lineup, const RecordedGame& game, std::uint64_t seed) const {
    const contest::Cast cast(lineup, seed);
    const Params& params = cast.params();
    const Tick from = ticks(from_);
    ReplayedGame played{.report = {.seed = seed}, .replay = replay::Replay(game.recording, from, recorded())};
    robot::bridge::SimulatedGame simulated(params, {.rules = choice_.rules, .teams = game.teams},
                                           played.replay.begin(params, {.seed = seed}));
    std::optional<GameFile> file;
    if (!mcap_.empty()) {
      auto made = GameFile::create(mcap_, simulated, seed);
      if (!made) return made.failure();
      file.emplace(std::move(*made));
      if (const auto added = file->add(simulated); !added) return added.failure();
    }
    referee::Events events;
    const Tick end = std::min(ticks(seconds_), game.recording.length - from);
    bool goal = false;
    while (simulated.state().world.tick < end && !goal && !simulated.finished() && !cast.failed()) {
      simulated.tick(events);
      simulated.change([&](State& state) { played.replay.place(params, state); });
      if (file)
        if (const auto added = file->add(simulated); !added) return added.failure();
      goal = note(simulated.state(), events, played) && side_ != "both";
    }
    if (file)
      if (const auto closed = file->close(); !closed) return closed.failure();
    if (cast.failed()) return robot::Error{cast.problem()};
    played.report.hash = hash_of_game(simulated.state());
    played.report.result = result_of(simulated.state());
    for (const report::Decision& decision : played.report.decisions) played.report.result.count(decision.event);
    return played;
  }

  /// Notes the referee's decisions but those about recorded robots. Returns whether there is a goal.
  static bool note(const State& state, const referee::Events& events, ReplayedGame& played) {
    bool goal = false;
    for (const referee::Event& event : events) {
      goal = goal || event.kind == Kind::goal;
      if (event.kind != Kind::goal && is_about(event, played.replay)) continue;
      played.report.decisions.push_back({.event = event,
                                         .half = state.book.half,
                                         .clock = static_cast<float>(state.book.clock) * kTickDuration,
                                         .score = {state.book.score[0], state.book.score[1]}});
    }
    return goal;
  }

  static std::string name_of(const RecordedGame& game, int robot) {
    return std::to_string(game.teams.of(side_of(robot))) + "/" +
           std::to_string(game.players[static_cast<std::size_t>(robot)]);
  }

  /// Returns the robots of the playing side that have no data at the start, so that they do not play.
  report::Json not_playing(const ReplayedGame& played, const RecordedGame& game) const {
    report::Json list = report::Json::array();
    for (int robot = 0; robot < kMaxRobots; ++robot) {
      const replay::Track& track = game.recording.robots[static_cast<std::size_t>(robot)];
      if (!played.replay.is_recorded(robot) && !track.empty() && !track.at(ticks(from_)))
        list.push_back(name_of(game, robot));
    }
    return list;
  }

  /// Returns the robots of the recorded side whose data were missing for some time.
  report::Json missing_of(const ReplayedGame& played, const RecordedGame& game) const {
    report::Json list = report::Json::array();
    for (int robot = 0; robot < kMaxRobots; ++robot) {
      const replay::Replay::Missing& missing = played.replay.missing(robot);
      if (missing.held + missing.absent == 0) continue;
      list.push_back({{"robot", name_of(game, robot)},
                      {"stood_seconds", static_cast<double>(missing.held) / kTicksPerSecond},
                      {"absent_seconds", static_cast<double>(missing.absent) / kTicksPerSecond}});
    }
    return list;
  }

  report::Json json_of(const ReplayedGame& played, const RecordedGame& game, const Params& params) const {
    report::Json json = report::to_json(played.report, params.rules.players);
    json["recorded"] = side_;
    json["from"] = from_;
    json["without_data"] = missing_of(played, game);
    json["not_playing"] = not_playing(played, game);
    return json;
  }

  report::Json line_of(const ReplayedGame& played, const RecordedGame& game, const Params& params) const {
    report::Json json = json_of(played, game, params);
    json.erase("events");
    return json;
  }

  void print(const ReplayedGame& played, const RecordedGame& game, const Params& params) const {
    if (json_) {
      std::printf("%s\n", json_of(played, game, params).dump(2).c_str());
      return;
    }
    std::fputs(report::to_text(played.report, choice_, params).c_str(), stdout);
    std::printf("\nas recorded from %s s on: %s\n", io::short_text(from_).c_str(),
                side_ == "both" ? "both sides and the ball" : side_.c_str());
    for (const report::Json& robot : not_playing(played, game))
      std::printf("no data of %s at the start: it does not play\n", robot.get<std::string>().c_str());
    for (const report::Json& robot : missing_of(played, game))
      std::printf("no data of %s: it stands still for %.1f s and is absent for %.1f s\n",
                  robot["robot"].get<std::string>().c_str(), robot["stood_seconds"].get<double>(),
                  robot["absent_seconds"].get<double>());
  }

  void print(const std::vector<report::GameReport>& reports, const Params& params) const {
    if (json_)
      std::printf("%s\n", report::to_json(reports, params.rules.players).dump(2).c_str());
    else
      std::fputs(report::to_text(reports, choice_, params).c_str(), stdout);
  }

  std::string session_, side_ = "away", strategy_ = "baseline", rules_, models_ = "match", mcap_;
  float from_ = 0, seconds_ = 30;
  std::uint64_t seed_ = 1;
  int games_ = 1;
  WantedTeams wanted_;
  bool json_ = false, lines_ = false;
  io::Matchup choice_;
};

}  // namespace

std::unique_ptr<Command> replay_command(CLI::App& app) { return std::make_unique<ReplayCommand>(app); }

}  // namespace sim::app
