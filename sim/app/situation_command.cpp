// foresight-sim situation: plays on from a described moment of a game, many times.
#include <algorithm>
#include <cstdio>
#include <map>
#include <memory>

#include "robot/core/json_library.h"
#include "sim/app/commands.h"
#include "sim/app/progress.h"
#include "sim/contest/lineup_series.h"
#include "sim/contest/openings.h"
#include "sim/io/playbook.h"
#include "sim/match/play.h"
#include "sim/report/game_report.h"
#include "sim/report/race_report.h"

namespace sim::app {
namespace {

using Kind = referee::Event::Kind;

/// The result of one continuation.
struct Rollout {
  int goals[2] = {0, 0};
  int shots[2] = {0, 0};
  int outs = 0;
  int first = -1;              // side of the first goal; -1: there was none
  double first_seconds = 0;    // [s] time of the first goal
  double possession_home = 0;  // [0..1]
};

/// A continuation that is being played.
class Continuation {
 public:
  State state;

  Continuation(const State& start, Tick length) : state(start), start_(start), end_(start.world.tick + length) {}

  bool goes_on() const { return state.world.tick < end_; }
  void see(const referee::Events& events) {
    for (const referee::Event& event : events) {
      if (referee::is_out(event.kind)) ++rollout_.outs;
      if (event.kind != Kind::goal || rollout_.first >= 0) continue;
      rollout_.first = static_cast<int>(event.side);
      rollout_.first_seconds = static_cast<double>(age(event.tick, start_.world.tick));
    }
  }
  Rollout rollout() const {
    Rollout rollout = rollout_;
    for (const int side : {0, 1}) {
      rollout.goals[side] = state.book.score[side] - start_.book.score[side];
      rollout.shots[side] = state.counts.shots[side] - start_.counts.shots[side];
    }
    rollout.possession_home = static_cast<double>(result_of(state).possession(Side::home));
    return rollout;
  }

 private:
  const State start_;
  const Tick end_;
  Rollout rollout_;
};

/// The summary of all rollouts.
struct Summary {
  std::map<int, int> goals[2];    // rollouts by the number of goals
  std::vector<double> counts[2];  // goals
  std::vector<double> shots[2];
  std::vector<double> outs, possession_home;
  std::vector<double> first_at[2];  // [s]

  explicit Summary(const std::vector<Rollout>& rollouts) {
    for (const Rollout& rollout : rollouts) {
      for (const int side : {0, 1}) {
        ++goals[side][rollout.goals[side]];
        counts[side].push_back(rollout.goals[side]);
        shots[side].push_back(rollout.shots[side]);
      }
      outs.push_back(rollout.outs);
      possession_home.push_back(rollout.possession_home);
      if (rollout.first >= 0) first_at[rollout.first].push_back(rollout.first_seconds);
    }
  }
};

report::Json json_of(const contest::Mean& mean) { return {{"mean", mean.mean}, {"standard_error", mean.error}}; }

/// Returns a share with its error, as the mean of zeros and ones.
contest::Mean share_of(std::size_t yes, std::size_t all) {
  std::vector<double> values(all, 0);
  std::fill_n(values.begin(), yes, 1);
  return contest::mean_of(values);
}

report::Json to_json(const Summary& summary, double seconds) {
  const std::size_t rollouts = summary.outs.size();
  report::Json json = {{"rollouts", rollouts}, {"seconds", seconds}};
  for (const int side : {0, 1}) {
    report::Json distribution = report::Json::object();
    for (const auto& [goals, count] : summary.goals[side]) distribution[std::to_string(goals)] = count;
    json[side == 0 ? "home" : "away"] = {
        {"goals", json_of(contest::mean_of(summary.counts[side]))},
        {"goals_distribution", distribution},
        {"shots", json_of(contest::mean_of(summary.shots[side]))},
        {"first_goal", json_of(share_of(summary.first_at[side].size(), rollouts))},
        {"first_goal_seconds",
         summary.first_at[side].empty() ? report::Json() : json_of(contest::mean_of(summary.first_at[side]))}};
  }
  json["ball_out"] = json_of(contest::mean_of(summary.outs));
  json["possession_home"] = json_of(contest::mean_of(summary.possession_home));
  return json;
}

void print(const Summary& summary, double seconds) {
  const std::size_t rollouts = summary.outs.size();
  std::printf("%zu rollouts of %g s\n\n%-22s%18s%18s\n", rollouts, seconds, "", "home", "away");
  const auto line = [&](const char* what, double scale, const contest::Mean& home, const contest::Mean& away,
                        const char* unit) {
    std::printf("%-22s%9.2f ± %-6.2f%9.2f ± %-6.2f %s\n", what, scale * home.mean, scale * home.error,
                scale * away.mean, scale * away.error, unit);
  };
  line("goals", 1, contest::mean_of(summary.counts[0]), contest::mean_of(summary.counts[1]), "");
  line("shots", 1, contest::mean_of(summary.shots[0]), contest::mean_of(summary.shots[1]), "");
  line("first goal", 100, share_of(summary.first_at[0].size(), rollouts),
       share_of(summary.first_at[1].size(), rollouts), "%");
  line("  scored after", 1, contest::mean_of(summary.first_at[0]), contest::mean_of(summary.first_at[1]), "s");

  int most = 0;
  for (const auto& goals : summary.goals) most = std::max(most, goals.rbegin()->first);
  std::printf("\n%-22s", "goals");
  for (int goals = 0; goals <= most; ++goals) std::printf("%8d", goals);
  for (const int side : {0, 1}) {
    std::printf("\n  %-20s", side == 0 ? "home" : "away");
    for (int goals = 0; goals <= most; ++goals) {
      const auto found = summary.goals[side].find(goals);
      std::printf("%8d", found == summary.goals[side].end() ? 0 : found->second);
    }
  }
  const contest::Mean outs = contest::mean_of(summary.outs), possession = contest::mean_of(summary.possession_home);
  std::printf("\n\nball out    %.2f ± %.2f\npossession  home %.1f ± %.1f %%\n", outs.mean, outs.error,
              100 * possession.mean, 100 * possession.error);
}

std::vector<std::string> listed(const auto& names) { return {names.begin(), names.end()}; }

std::size_t index_of(const std::string& name, const auto& names) {
  return static_cast<std::size_t>(std::find(names.begin(), names.end(), name) - names.begin());
}

class SituationCommand final : public Command {
 public:
  explicit SituationCommand(CLI::App& app)
      : Command(app.add_subcommand("situation", "play on from a described moment, many times")) {
    options().add_option("file", file_, "name or file of the moment, or a folder of moments, used in turn")->required();
    choice_.add_to(options());
    options()
        .add_option(
            "--rollouts", rollouts_,
            "number of continuations, each with its own random numbers; with --strategies the mean per strategy")
        ->check(CLI::Range(1, 1'000'000))
        ->capture_default_str();
    options()
        .add_option("--seconds", seconds_, "[s] length of each continuation")
        ->check(CLI::Range(0.1, 36000.))
        ->capture_default_str();
    options().add_flag("--fuzz", fuzz_, "each begins with slightly shifted robots and ball");
    options()
        .add_option("--strategies", strategies_,
                    "compare these strategies of the home side from here on; the first is the one that is played now")
        ->delimiter(',');
    options()
        .add_option("--measure", measure_, "the measure that compares --strategies")
        ->check(CLI::IsMember(listed(foresight::kMeasureNames)))
        ->capture_default_str();
    options()
        .add_option("--until", until_, "end of the futures of --strategies; horizon: --seconds")
        ->check(CLI::IsMember(listed(foresight::kUntilNames)))
        ->capture_default_str();
    options().add_flag("--json", json_, "report as JSON");
  }

  int run() override { return strategies_.empty() ? play_on() : choose(); }

 private:
  /// Plays on from the moment and prints a summary.
  int play_on() {
    const auto lineup = choice_.line_up();
    if (!lineup) return fail(lineup.error());
    const auto openings = contest::Openings::read(file_, fuzz_, lineup->params());
    if (!openings) return fail(openings.error());

    contest::Costs costs;
    std::vector<Rollout> rollouts(static_cast<std::size_t>(rollouts_));
    const auto played = [&] {
      ProgressBar progress("rolling out", static_cast<std::uint64_t>(rollouts_));
      return contest::play_series(
          *lineup, {.games = rollouts_, .costs = &costs},
          [&](int, std::uint64_t seed, const contest::Cast& cast) {
            return std::make_unique<Continuation>(openings->begin(cast.params(), seed),
                                                  ticks(static_cast<float>(seconds_)));
          },
          [&](int i, const Continuation& ended, const contest::Cast&) {
            rollouts[static_cast<std::size_t>(i)] = ended.rollout();
          },
          [&](int done) { progress.at(static_cast<std::uint64_t>(done)); });
    }();
    if (!played) return fail(played.error());
    const Summary summary(rollouts);
    if (json_) {
      std::printf("%s\n", to_json(summary, seconds_).dump(2).c_str());
    } else {
      print(summary, seconds_);
      std::fputs(costs.text().c_str(), stdout);
    }
    return kDone;
  }

  /// Compares the strategies of --strategies.
  int choose() {
    const auto playbook = choice_.playbook(strategies_);
    if (!playbook) return fail(playbook.error());
    const auto openings = contest::Openings::read(file_, fuzz_, playbook->params.front());
    if (!openings) return fail(openings.error());

    // a description has no doubt
    const foresight::Situation situation{.state = openings->begin(playbook->params.front(), 0), .doubt = {}};
    const foresight::Question question{
        .measure = static_cast<foresight::Measure>(index_of(measure_, foresight::kMeasureNames)),
        .until = static_cast<foresight::Until>(index_of(until_, foresight::kUntilNames)),
        .horizon = ticks(static_cast<float>(seconds_))};
    const foresight::Task task = io::task_of(*playbook, situation, question, situation.state.world.key);
    const double budget = static_cast<double>(rollouts_) * static_cast<double>(strategies_.size());
    foresight::RolloutStatistics tally;
    {
      ProgressBar progress("rolling out", static_cast<std::uint64_t>(budget));
      foresight::race(
          task, [&](std::int64_t rollouts) { return static_cast<double>(rollouts) / budget; },
          [&](const foresight::RolloutStatistics& now) { progress.at(static_cast<std::uint64_t>(now.spent * budget)); },
          tally);
    }
    const foresight::Forecast forecast = foresight::forecast(tally, task.question, task.key);
    if (json_)
      std::printf("%s\n", report::race_json(forecast, task.question, strategies_).dump(2).c_str());
    else
      report::print_race(forecast, task.question, strategies_);
    return kDone;
  }

  ChoiceOptions choice_;
  std::string file_;
  std::vector<std::string> strategies_;
  std::string measure_ = "goal_difference", until_ = "horizon";
  int rollouts_ = 200;
  double seconds_ = 60;
  bool json_ = false, fuzz_ = false;
};

}  // namespace

std::unique_ptr<Command> situation_command(CLI::App& app) { return std::make_unique<SituationCommand>(app); }

}  // namespace sim::app
