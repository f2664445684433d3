// The reading of drives from recordings.
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <optional>
#include <utility>

#include "proto/foresight/game.pb.h"
#include "proto/foresight/motion.pb.h"
#include "robot/fit/walking/drives.h"
#include "robot/logging/sessions/read_all.h"

namespace robot::fit {
namespace {

using sim::motion::Command;

constexpr double kNearRobot = 0.5;     // [m] between two robots: they may touch
constexpr double kSameTime = 1e-9;     // [s]
constexpr double kItself = 0.05;       // [m] nearer places are those of the robot itself
constexpr double kLookRound = 0.2;     // [s] between two looks at the neighbours
constexpr double kTooOld = 0.1;        // [s] between a place and that of a neighbour
constexpr double kOften = 0.1;         // [s] between two moments of one disturbance
constexpr double kFastestAsked = 5;    // [m/s], [rad/s] a faster command is damaged
constexpr double kFarthestAsked = 30;  // [m]

/// Returns the command of a message: nothing if it is damaged. `usable` is false if it asks for more than walking.
std::optional<Command> command_of(const foresight::MotionCommand& message, const Command& before, bool& usable) {
  Command command;
  const auto is_sound = [](double x, double y, double turn, double most) {
    return std::abs(x) <= most && std::abs(y) <= most && std::abs(turn) <= kFastestAsked;
  };
  switch (message.body_case()) {
    case foresight::MotionCommand::kWalkSpeed: {
      const foresight::WalkSpeed& speed = message.walk_speed();
      if (!is_sound(speed.x(), speed.y(), speed.turn_rate(), kFastestAsked)) return std::nullopt;
      command.body = Command::Body::walk_speed;
      command.walk = {speed.x(), speed.y()};
      command.turn = speed.turn_rate();
      break;
    }
    case foresight::MotionCommand::kWalkTo: {
      const foresight::WalkTo& to = message.walk_to();
      if (!is_sound(to.x(), to.y(), to.heading(), kFarthestAsked) || !(to.gain() >= 0 && to.gain() <= 1))
        return std::nullopt;
      command.body = to.gain() > 0 ? Command::Body::walk_to : Command::Body::stand;
      command.walk = {to.x(), to.y()};
      command.turn = to.heading();
      command.gain = to.gain();
      break;
    }
    case foresight::MotionCommand::kPosture:
      usable = message.posture() == foresight::MotionCommand::POSTURE_STAND;
      break;
    case foresight::MotionCommand::BODY_NOT_SET: return before;
    default: usable = false;
  }
  return command;
}

std::vector<TimedCommand> commands_of(const WatchedRobot& robot, std::size_t& damaged) {
  std::vector<TimedCommand> commands;
  const auto add = [&](const foresight::MotionCommand& message, std::uint64_t capture_ns) {
    const TimedCommand before = commands.empty() ? TimedCommand{} : commands.back();
    bool usable = message.body_case() != foresight::MotionCommand::BODY_NOT_SET || before.usable;
    const auto command = command_of(message, before.command, usable);
    if (!command) ++damaged;
    commands.push_back(
        {.at = robot.true_seconds(capture_ns), .command = command.value_or(Command{}), .usable = usable && command});
  };
  logging::read_each<foresight::MotionCommand>(robot.session, "/" + robot.session.info.robot + "/motion_command", add);
  std::ranges::stable_sort(commands, {}, &TimedCommand::at);
  return commands;
}

/// Collects disturbed moments and halts from a robot's status.
class StatusReader {
 public:
  StatusReader(const WatchedRobot& robot, std::size_t index, DriveLimits& limits, Drives& drives)
      : robot_(robot), index_(index), limits_(limits), drives_(drives) {}

  void read() {
    const std::string topic = "/" + robot_.session.info.robot + "/motion_status";
    const auto add = [this](const foresight::MotionStatus& status, std::uint64_t capture_ns) {
      add_status(status, robot_.true_seconds(capture_ns));
    };
    logging::read_each<foresight::MotionStatus>(robot_.session, topic, add);
  }

 private:
  void add_status(const foresight::MotionStatus& status, double at) {
    const bool lies = status.fall() > foresight::MotionStatus::FALL_UPRIGHT;
    const bool lifted = status.has_ground_contact() && !status.ground_contact();
    const bool disturbed = !status.running().empty() || lies || lifted;
    if (disturbed && (limits_.disturbed.empty() || at - limits_.disturbed.back() >= kOften))
      limits_.disturbed.push_back(at);
    add_halt(status, at, disturbed);
    last_ = at;
  }

  void add_halt(const foresight::MotionStatus& status, double at, bool disturbed) {
    const double middle = (last_ + at) / 2, step = at - last_;
    if (disturbed || !(step > 0 && step < kOften)) {
      halt_.reset();
    } else if (status.stopping()) {
      // the speed before counts too: it brakes within the first message's time
      if (!halt_ && was_walking_)
        halt_ = Halt{.robot = index_, .at = middle, .speed = speed_, .turn_rate = rate_, .resolution = step};
    } else {
      if (halt_ && status.standing()) {
        halt_->duration = middle - halt_->at;
        drives_.halts.push_back(*halt_);
      }
      halt_.reset();
    }
    was_walking_ = status.walking() && !status.stopping();
    speed_ = std::hypot(status.velocity_x(), status.velocity_y());
    rate_ = std::abs(status.turn_rate());
  }

  const WatchedRobot& robot_;
  const std::size_t index_;
  DriveLimits& limits_;
  Drives& drives_;
  double last_ = -INFINITY;
  bool was_walking_ = false;
  double speed_ = 0, rate_ = 0;
  std::optional<Halt> halt_;
};

/// Adds the times in which the referee has penalised the robot.
void add_penalties(const WatchedRobot& robot, DriveLimits& limits) {
  double since = NAN;
  const auto until = [&](double at) {
    for (double moment = since; moment < at; moment += kOften) limits.disturbed.push_back(moment);
  };
  const auto add = [&](const foresight::GameState& game, std::uint64_t capture_ns) {
    const double at = robot.true_seconds(capture_ns);
    until(at);
    const auto own = static_cast<int>(game.own_player()) - 1;
    const bool known = own >= 0 && own < game.own().players_size();
    since = known && game.own().players(own).penalised() ? at : NAN;
  };
  logging::read_each<foresight::GameState>(robot.session, "/" + robot.session.info.robot + "/game", add);
  if (!robot.path.empty()) until(robot.path.back().at);
}

/// Adds the moments at which another robot is near.
void add_neighbours(const WatchedRobot& robot, DriveLimits& limits) {
  double next = -INFINITY;
  std::vector<std::size_t> at_place(robot.game->record.robots.size());
  for (const lab::PlaceAt& place : robot.path) {
    if (place.at < next) continue;
    next = place.at + kLookRound;
    for (std::size_t i = 0; i < at_place.size(); ++i) {
      const lab::Path& path = robot.game->record.robots[i].path;
      std::size_t& k = at_place[i];
      // the robot's own path has this very place; an older one of it would seem to be another robot
      while (k < path.size() && path[k].at < place.at - kSameTime) ++k;
      if (k == path.size() || path[k].at > place.at + kTooOld) continue;
      const double far = std::hypot(path[k].x - place.x, path[k].y - place.y);
      if (far < kNearRobot && far > kItself) limits.disturbed.push_back(place.at);
    }
  }
}

/// Returns the index of the first robot with the same clock: robots of one recording that holds the truth share its clock.
std::size_t clock_of(const WatchedRobot& robot, const std::vector<const WatchedRobot*>& before) {
  const auto shares = [&](const WatchedRobot* other) {
    return robot.clock_by.empty() && other->clock_by.empty() && other->game == robot.game;
  };
  return static_cast<std::size_t>(std::ranges::find_if(before, shares) - before.begin());
}

bool has_heading(const lab::Path& path) {
  return std::ranges::any_of(path, [](const lab::PlaceAt& place) { return std::isfinite(place.heading); });
}

}  // namespace

Drives read_drives(const Evidence& evidence) {
  Drives all;
  std::vector<const lab::Path*> paths;
  std::vector<const WatchedRobot*> readers;  // with a drive or a halt
  for (const WatchedRobot& robot : evidence.robots) {
    const std::vector<TimedCommand> commands = commands_of(robot, all.damaged);
    if (commands.empty()) ++all.without_command;
    if (!commands.empty() && !has_heading(robot.path)) ++all.without_heading;
    if (commands.empty() || !has_heading(robot.path)) continue;
    const std::size_t drives = all.drives.size(), halts = all.halts.size();
    all.robots.push_back(robot.name);
    DriveLimits limits;
    StatusReader(robot, all.robots.size() - 1, limits, all).read();
    add_penalties(robot, limits);
    add_neighbours(robot, limits);
    std::ranges::sort(limits.disturbed);
    cut_drives(commands, robot.path, limits, all);
    if (all.drives.size() == drives && all.halts.size() == halts) {
      all.robots.pop_back();
      continue;
    }
    const double middle = robot.path[robot.path.size() / 2].at;
    all.clock_deviation.push_back(robot.clock.deviation_at(middle));
    all.clocks.push_back(clock_of(robot, readers));
    readers.push_back(&robot);
    paths.push_back(&robot.path);
  }
  measure_scatter(paths, all);
  return all;
}

}  // namespace robot::fit
