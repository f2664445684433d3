// The falls of a game, and the time in which robots could fall.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "robot/fit/evidence.h"

namespace robot::fit {

/// One fall, by the truth.
struct TrueFall {
  double at = 0;               // [s] of its begin, since the epoch of the truth
  bool walking = false;        // just before
  bool touching = false;       // another robot, just before
  std::optional<double> down;  // [s] on the ground; absent where the end was not seen
};

/// One robot of a truth: its falls, and the time in which it was upright.
struct FallRisk {
  std::size_t recording = 0;  // index of the truth
  std::string robot;
  double walking = 0;      // [s] in all
  double touching = 0;     // [s] in all, walking or not
  double overlapping = 0;  // [s] nearer to another one than robots can be: by the error of the truth
  double upright = 0;      // [s]
  std::vector<TrueFall> falls;
};

/// The radii of robots against each other [m].
struct RobotSizes {
  double upright = 0.16, lying = 0.25;
};

/// Finds the falls of all robots that the truth judges. A robot goes down when it is down in 22 of the 30 images around, and is up
/// again when it is down in 8 of them. A robot that is down when it comes into view fell before.
/// It walks if it moved by 3 to 40 cm or turned by 5° within half a second. It touches another robot nearer than
/// the sum of their radii, with two errors of the truth added.
std::vector<FallRisk> falls_in(const lab::TruthRecord& truth, const RobotSizes& sizes, std::size_t recording);

/// The phases of the falls that a robot recorded itself.
struct FallPhases {
  std::vector<double> lying, getting_up;   // [s] complete ones
  std::size_t attempts = 0, failures = 0;  // to get up
  double interval = 0;                     // [s] mean between two messages
};

/// Reads the phases of a robot from its motion status.
FallPhases read_fall_phases(const WatchedRobot& robot);

}  // namespace robot::fit
