// Robots that walk a drill with known parameters, in a ground truth with an error.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "robot/fit/walking/drives.h"
#include "sim/match/params.h"

namespace robot::tests {

/// Returns models of which only the walk and its effects count.
sim::Models walking_models();

struct PlantedWalks {
  sim::Models models = walking_models();
  std::size_t robots = 1;       // at most 14
  double seconds = 240;         // of the drill of each robot
  bool to_places = false;       // walks to far places as in a game, instead of the drill
  bool ahead_only = false;      // the drill only walks ahead, with stops
  double truth_error = 0.02;    // [m] one standard deviation of each coordinate
  double heading_error = 0.02;  // [rad]
  double late = 0;             // [s] one standard deviation by which a robot's commands seem to come later than they do
  double clock_deviation = 0;  // [s] that each recording reports
  bool mirrored = false;       // the field, the commands and the luck of the truth's errors
};

/// One robot of a drill.
struct WalkedDrill {
  std::vector<fit::TimedCommand> commands;
  lab::Path path;
  std::vector<fit::Halt> halts;
  double pace = 1;  // of the fastest robot's
};

/// Returns the same for the same seed, which also gives the paces.
std::vector<WalkedDrill> walked_drills(const PlantedWalks& planted, std::uint64_t seed);

/// Returns the drives of drills. The robots are named "robot 1" and so on.
fit::Drives drives_of(const std::vector<WalkedDrill>& drills, double clock_deviation);

}  // namespace robot::tests
