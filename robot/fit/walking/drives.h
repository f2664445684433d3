// The commands of robots to walk, beside their true paths.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "robot/fit/evidence.h"
#include "sim/motion/command.h"

namespace robot::fit {

/// A robot's true pose during a drive.
struct DrivePose {
  double tick = 0;                   // [ticks of 1/30 s] since the begin of the drive
  double x = 0, y = 0, heading = 0;  // [m, m, rad, field]; the heading is continuous, beyond ±π
};

/// A part of a robot's path of at most 20 s, in which nobody and nothing disturbs the walk. Drives of one robot overlap only in
/// their first ticks, before `settled`.
struct Drive {
  std::size_t robot = 0;                       // index
  double at = 0;                               // [s] its begin, clock of the truth
  std::vector<sim::motion::Command> commands;  // for each tick of 1/30 s
  std::vector<DrivePose> poses;                // in the order of the times
  std::size_t settled = 0;  // [ticks] before, the motion may still depend on commands before the drive
};

/// The end of a walk, by the robot's own status.
struct Halt {
  std::size_t robot = 0;
  double at = 0;          // [s] clock of the truth
  double duration = 0;    // [s] from `stopping` to `standing`
  double speed = 0;       // [m/s] at its begin
  double turn_rate = 0;   // [rad/s] likewise
  double resolution = 0;  // [s] between two messages of the status
};

struct Drives {
  std::vector<Drive> drives;  // ordered by robot and time
  std::vector<Halt> halts;
  std::vector<std::string> robots;      // names of those with a drive or a halt, by index
  std::vector<double> clock_deviation;  // [s] of each robot
  std::vector<std::size_t> clocks;      // for each robot, the first one with the same clock: that of one recording
  double place_deviation = 0.02;        // [m] of either coordinate of a true place
  double heading_deviation = 0.02;      // [rad]
  std::size_t without_command = 0;      // robots that recorded no command
  std::size_t without_heading = 0;      // robots whose truth has no heading
  std::size_t damaged = 0;              // commands that are not finite or absurd
  double disturbed = 0;                 // [s] left out: a kick, a fall, a penalty, or another robot within half a metre
};

/// The times that a drive avoids.
struct DriveLimits {
  std::vector<double> disturbed;  // [s] moments, ordered, clock of the truth
};

/// A command and its time [s, clock of the truth]; not `usable` where it asks for more than walking.
struct TimedCommand {
  double at = 0;
  sim::motion::Command command;
  bool usable = true;
};

/// Cuts a robot's path into drives. Commands hold until the next one, at most half a second. Standing for long is left out.
/// `commands` are ordered. Adds to `drives`, with the index of its last robot.
void cut_drives(const std::vector<TimedCommand>& commands, const lab::Path& path, const DriveLimits& limits,
                Drives& drives);

/// Estimates the deviations of places and headings from their scatter around straight lines through three in a row.
void measure_scatter(const std::vector<const lab::Path*>& paths, Drives& drives);

/// Reads the commands, the status and the penalties of each robot.
Drives read_drives(const Evidence& evidence);

}  // namespace robot::fit
