// The errors of a fitted walk on drives held out, and its pictures.
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <string>
#include <utility>
#include <vector>

#include "robot/core/text.h"
#include "robot/fit/walking/walking.h"
#include "robot/lab/clocks/belief_error.h"
#include "sim/motion/walk.h"

namespace robot::fit {
namespace {

using sim::motion::Command, sim::motion::Walk;

constexpr std::size_t kWalkFolds = 5;
constexpr double kStartSeconds = 1.5;  // [s] of a start that is drawn
constexpr double kDegreesARadian = 57.29578;

/// Returns the rates of a robot that goes where it is commanded: at once, with no luck and no cost of turning.
WalkRates commanded_rates(const Walk& ideal, const Command& command) {
  if (!asks_to_walk(command)) return {};
  if (command.body == Command::Body::walk_speed) return {command.walk.x, command.walk.y, command.turn};
  return mean_gait(ideal, command).mean;
}

Walk ideal_of(const sim::Models& base) {
  Walk ideal = base.motion.walk;
  ideal.turn_cost = 0, ideal.speed_noise = 0, ideal.turn_noise = 0;
  return ideal;
}

std::vector<WalkRates> commanded_walk(const Walk& ideal, const Drive& drive) {
  std::vector<WalkRates> rates;
  for (const Command& command : drive.commands) rates.push_back(commanded_rates(ideal, command));
  return rates;
}

/// The absolute errors of a model over seconds.
struct WalkErrors {
  std::vector<double> places, turns;  // [m], [rad]

  std::vector<std::string> row(const std::string& name) const {
    double turn = 0;
    for (const double one : turns) turn += one / static_cast<double>(turns.size());
    const lab::ErrorFigures figures = lab::figures_of(places);
    return {name, formatted("%.1f", 100 * figures.mean), formatted("%.1f", 100 * figures.median),
            formatted("%.1f", 100 * figures.p95), formatted("%.1f", kDegreesARadian * turn)};
  }
  double mean() const { return lab::figures_of(places).mean; }
};

/// Reports whether the second from `block` on has its places and a command to walk.
bool is_walk(const DriveTrack& track, std::size_t block) {
  if (block + kBlocksASecond >= track.blocks()) return false;
  if (track.places_in(block) < 2 || track.places_in(block + kBlocksASecond) < 2) return false;
  const auto& commands = track.drive().commands;
  const std::size_t from = track.middle_of(block), to = track.middle_of(block + kBlocksASecond);
  return std::any_of(commands.begin() + static_cast<std::ptrdiff_t>(from),
                     commands.begin() + static_cast<std::ptrdiff_t>(to), asks_to_walk);
}

void add_walk_errors(const DriveTrack& track, const std::vector<BlockMean>& path, WalkErrors& errors) {
  for (std::size_t i = 0; i < track.blocks(); i += kBlocksASecond) {
    if (!is_walk(track, i)) continue;
    const BlockStep missed = missed_between(track, path, i, i + kBlocksASecond);
    errors.places.push_back(std::hypot(missed.ahead, missed.left));
    errors.turns.push_back(std::abs(missed.turn));
  }
}

/// Returns the path of a drive by a state.
std::vector<BlockMean> path_by(const DriveTrack& track, const WalkState& state, const Walk& base) {
  const std::size_t robot = track.drive().robot;
  return track.predicted(mean_walk(state.walk_of(robot, base), track.drive().commands), state.late(robot));
}

/// The dots of achieved over commanded speeds, of seconds with a steady command.
struct Achieved {
  std::vector<double> ahead_asked, ahead, aside_asked, aside, turn_asked, turn;
};

void add_achieved(const DriveTrack& track, const std::vector<WalkRates>& asked, Achieved& achieved) {
  for (std::size_t i = 0; i + kBlocksASecond < track.blocks(); ++i) {
    if (!is_walk(track, i)) continue;
    // a second before, in which the robot came to its speed
    const std::size_t from = track.middle_of(i), to = track.middle_of(i + kBlocksASecond),
                      early = from - std::min<std::size_t>(from, 25);
    const WalkRates& middle = asked[(from + to) / 2];
    const bool steady = std::all_of(asked.begin() + static_cast<std::ptrdiff_t>(early),
                                    asked.begin() + static_cast<std::ptrdiff_t>(to), [&](const WalkRates& rates) {
                                      return std::hypot(rates.x - middle.x, rates.y - middle.y) < 0.03 &&
                                             std::abs(rates.turn - middle.turn) < 0.15;
                                    });
    if (!steady) continue;
    const BlockStep step = seen_between(track, i, i + kBlocksASecond);
    const double x = std::abs(middle.x), y = std::abs(middle.y), turn = std::abs(middle.turn);
    if (x > 0.03 && y < 0.1 * x && turn < 0.1)
      achieved.ahead_asked.push_back(middle.x), achieved.ahead.push_back(step.ahead);
    if (y > 0.03 && x < 0.1 * y && turn < 0.1)
      achieved.aside_asked.push_back(middle.y), achieved.aside.push_back(step.left);
    if (turn > 0.1) achieved.turn_asked.push_back(middle.turn), achieved.turn.push_back(step.turn);
  }
}

Mark walk_dots_of(std::vector<double> x, std::vector<double> y, Mark::Role role, const char* label) {
  return {.shape = Mark::Shape::dots, .role = role, .label = label, .x = std::move(x), .y = std::move(y), .high = {}};
}

Mark walk_line_of(std::vector<double> x, std::vector<double> y, Mark::Role role, const char* label) {
  return {.shape = Mark::Shape::line, .role = role, .label = label, .x = std::move(x), .y = std::move(y), .high = {}};
}

double greatest_of(const std::vector<double>& values, double least) {
  for (const double value : values) least = std::max(least, std::abs(value));
  return least;
}

/// Returns the walk of the mean robot.
Walk mean_robot(const FittedWalk& fitted) {
  WalkState state = fitted.fit.state;
  double mean = 0;
  const std::size_t robots = state.robots();
  for (std::size_t i = 0; i < robots; ++i) mean += state.log_pace(i) / static_cast<double>(robots);
  state.parameters[kWalkParts] = mean;
  return state.walk_of(0, fitted.fit.base);
}

/// Returns the line of the mean rate over the asked one, for commands that `command_of` makes.
template <class CommandOf, class RateOf>
Mark fitted_line(const Walk& walk, double most, const char* label, CommandOf command_of, RateOf rate_of) {
  Mark line = walk_line_of({}, {}, Mark::Role::fitted, label);
  for (int i = -40; i <= 40; ++i) {
    const double asked = most * i / 40;
    line.x.push_back(asked);
    line.y.push_back(i == 0 ? 0 : rate_of(mean_gait(walk, command_of(static_cast<float>(asked))).mean));
  }
  return line;
}

Command speed_command(float x, float y, float turn) {
  Command command;
  command.body = Command::Body::walk_speed;
  command.walk = {x, y};
  command.turn = turn;
  return command;
}

Picture speed_picture(const FittedWalk& fitted, const Achieved& achieved) {
  const double most = 1.1 * greatest_of(achieved.ahead_asked, greatest_of(achieved.aside_asked, 0.1));
  const Walk walk = mean_robot(fitted);
  Picture picture{.title = "Achieved over commanded speed",
                  .x_label = "commanded speed, walk_to: the models' greatest [m/s]",
                  .y_label = "achieved in one second [m/s]",
                  .axes = {.left = -most, .right = most, .bottom = -most, .top = most},
                  .marks = {}};
  picture.marks.push_back(walk_line_of({-most, most}, {-most, most}, Mark::Role::other, "as commanded"));
  picture.marks.push_back(walk_dots_of(achieved.ahead_asked, achieved.ahead, Mark::Role::truth, "ahead, back"));
  if (!achieved.aside.empty())
    picture.marks.push_back(
        walk_dots_of(achieved.aside_asked, achieved.aside, Mark::Role::robot, "to the left, right"));
  picture.marks.push_back(fitted_line(
      walk, most, "fitted, mean robot", [](float x) { return speed_command(x, 0, 0); },
      [](const WalkRates& rates) { return rates.x; }));
  if (!achieved.aside.empty())
    picture.marks.push_back(fitted_line(
        walk, most, "", [](float y) { return speed_command(0, y, 0); },
        [](const WalkRates& rates) { return rates.y; }));
  return picture;
}

Picture turn_picture(const FittedWalk& fitted, const Achieved& achieved) {
  const double most = 1.1 * greatest_of(achieved.turn_asked, 0.2);
  Picture picture{.title = "Achieved over commanded turn rate",
                  .x_label = "commanded turn rate [rad/s]",
                  .y_label = "achieved in one second [rad/s]",
                  .axes = {.left = -most, .right = most, .bottom = -most, .top = most},
                  .marks = {}};
  picture.marks.push_back(walk_line_of({-most, most}, {-most, most}, Mark::Role::other, "as commanded"));
  picture.marks.push_back(walk_dots_of(achieved.turn_asked, achieved.turn, Mark::Role::truth, "seconds"));
  picture.marks.push_back(fitted_line(
      mean_robot(fitted), most, "fitted", [](float turn) { return speed_command(0, 0, turn); },
      [](const WalkRates& rates) { return rates.turn; }));
  return picture;
}

/// The ways after starts: dots, and the sums of predicted ways for each tick.
struct WalkStarts {
  std::vector<double> at, way;
  std::vector<double> fitted, models;
  std::size_t count = 0;
};
constexpr auto kStartTicks = static_cast<std::size_t>(kStartSeconds * 30);

/// Reports whether the robot stood for a second before `tick`, and walks ahead for the whole time after it.
bool is_start(const std::vector<Command>& commands, std::size_t tick) {
  if (tick < 30 || tick + kStartTicks > commands.size()) return false;
  const auto at = commands.begin() + static_cast<std::ptrdiff_t>(tick);
  return std::none_of(at - 30, at, asks_to_walk) && std::all_of(at, at + kStartTicks, asks_to_walk);
}

void add_ways(const std::vector<WalkRates>& rates, std::size_t tick, std::vector<double>& sums) {
  sums.resize(kStartTicks + 1);
  double way = 0;
  for (std::size_t i = 0; i < kStartTicks; ++i) {
    way += std::hypot(rates[tick + i].x, rates[tick + i].y) / 30;
    sums[i + 1] += way;
  }
}

void add_starts(const DriveTrack& track, const FittedWalk& fitted, const Walk& models, WalkStarts& starts) {
  const Drive& drive = track.drive();
  for (std::size_t tick = 0; tick < drive.commands.size(); ++tick) {
    if (!is_start(drive.commands, tick)) continue;
    const auto between = [&](double from, double to) {
      BlockMean mean;
      double count = 0;
      for (const DrivePose& pose : drive.poses)
        if (pose.tick >= from && pose.tick < to) mean.x += pose.x, mean.y += pose.y, count += 1;
      return count > 0 ? BlockMean{mean.x / count, mean.y / count, 0} : BlockMean{NAN, NAN, 0};
    };
    const auto at = static_cast<double>(tick);
    const BlockMean rest = between(at - 15, at + 1), end = between(at + kStartTicks - 6, at + kStartTicks);
    const double far = std::hypot(end.x - rest.x, end.y - rest.y);
    if (!(far > 0.1)) continue;
    ++starts.count;
    for (const DrivePose& pose : drive.poses) {
      if (pose.tick < at - 6 || pose.tick > at + kStartTicks) continue;
      starts.at.push_back((pose.tick - at) / 30);
      starts.way.push_back(((pose.x - rest.x) * (end.x - rest.x) + (pose.y - rest.y) * (end.y - rest.y)) / far);
    }
    add_ways(mean_walk(fitted.fit.state.walk_of(drive.robot, fitted.fit.base), drive.commands), tick, starts.fitted);
    add_ways(mean_walk(models, drive.commands), tick, starts.models);
  }
}

Picture start_picture(const WalkStarts& starts) {
  Picture picture{.title = formatted("Way after %zu starts", starts.count),
                  .x_label = "time since the command [s]",
                  .y_label = "way [m]",
                  .axes = {.left = -0.2, .right = kStartSeconds, .bottom = -0.05, .top = greatest_of(starts.way, 0.2)},
                  .marks = {walk_dots_of(starts.at, starts.way, Mark::Role::truth, "true places")}};
  const auto mean_line = [&](const std::vector<double>& sums, Mark::Role role, const char* label) {
    Mark line = walk_line_of({}, {}, role, label);
    for (std::size_t i = 0; i < sums.size(); ++i)
      line.x.push_back(static_cast<double>(i) / 30), line.y.push_back(sums[i] / static_cast<double>(starts.count));
    return line;
  };
  picture.marks.push_back(mean_line(starts.models, Mark::Role::other, "models"));
  picture.marks.push_back(mean_line(starts.fitted, Mark::Role::fitted, "fitted, mean of all starts"));
  return picture;
}

}  // namespace

void add_walk_pictures(const FittedWalk& fitted, const sim::Models& base, Report& report) {
  Achieved achieved;
  WalkStarts starts;
  const Walk ideal = ideal_of(base);
  for (const DriveTrack& track : fitted.problem.tracks) {
    add_achieved(track, commanded_walk(ideal, track.drive()), achieved);
    if (starts.count < 60) add_starts(track, fitted, base.motion.walk, starts);
  }
  if (!achieved.ahead.empty() || !achieved.aside.empty()) report.pictures.push_back(speed_picture(fitted, achieved));
  if (starts.count > 0) report.pictures.push_back(start_picture(starts));
  if (!achieved.turn.empty()) report.pictures.push_back(turn_picture(fitted, achieved));
}

void add_walk_results(const FittedWalk& fitted, const Drives& drives, const sim::Models& base, Report& report) {
  const auto& tracks = fitted.problem.tracks;
  WalkErrors by_fit, by_models, by_command;
  Table table{
      .columns = {"time [s]", "ahead [m]", "left [m]", "turn [rad]", "commanded ahead [m/s]", "commanded left [m/s]",
                  "commanded turn [rad/s]", "missed ahead [m]", "missed left [m]", "missed turn [rad]"},
      .names = drives.robots,
      .rows = {}};
  const Walk ideal = ideal_of(base);
  for (std::size_t fold = 0; fold < kWalkFolds; ++fold) {
    std::vector<bool> left_out(tracks.size());
    for (std::size_t i = fold; i < tracks.size(); i += kWalkFolds) left_out[i] = true;
    const WalkState state = state_without(fitted.fit, fitted.problem, left_out);
    for (std::size_t i = fold; i < tracks.size(); i += kWalkFolds) {
      const std::vector<BlockMean> path = path_by(tracks[i], state, fitted.fit.base);
      add_walk_errors(tracks[i], path, by_fit);
      const Drive& drive = tracks[i].drive();
      add_walk_errors(tracks[i], tracks[i].predicted(mean_walk(base.motion.walk, drive.commands), 0), by_models);
      const std::vector<WalkRates> asked = commanded_walk(ideal, drive);
      add_walk_errors(tracks[i], tracks[i].predicted(asked, 0), by_command);
      for (std::size_t b = 0; b < tracks[i].blocks(); b += kBlocksASecond) {
        if (!is_walk(tracks[i], b)) continue;
        const BlockStep seen = seen_between(tracks[i], b, b + kBlocksASecond);
        const BlockStep missed = missed_between(tracks[i], path, b, b + kBlocksASecond);
        const WalkRates& command = asked[tracks[i].middle_of(b + 1)];
        table.rows.push_back(
            {.recording = drive.robot,
             .values = {drive.at + static_cast<double>(tracks[i].middle_of(b)) / 30, seen.ahead, seen.left, seen.turn,
                        command.x, command.y, command.turn, missed.ahead, missed.left, missed.turn}});
      }
    }
  }
  report.tables.push_back({"walk", std::move(table)});
  if (by_fit.places.empty()) return;
  report.results.push_back(
      {.title = formatted("Errors after 1 s of walking, %zu seconds, each fifth of the drives held out",
                          by_fit.places.size()),
       .head = {"", "mean [cm]", "median [cm]", "95 % [cm]", "turn [°]"},
       .rows = {by_fit.row("fitted walk"), by_models.row("default models"), by_command.row("goes where commanded")}});
  report.scores = {{"error_after_1s", by_fit.mean()},
                   {"error_after_1s_models", by_models.mean()},
                   {"error_after_1s_commanded", by_command.mean()}};
}

}  // namespace robot::fit
