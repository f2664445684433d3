// Speeds of the robots of a game, by the truth alone.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "robot/fit/evidence.h"

namespace robot::fit {

/// The walk of one robot.
struct SeenWalk {
  std::size_t recording = 0;   // index of the truth
  std::string robot;           // "14/2"
  std::string team;            // "14"; empty if the robot is not identified
  std::vector<double> speeds;  // [m/s] ten a second, standing included
};

/// Returns the walks of the robots of a truth. A speed is the displacement over 1 s of the place averaged over 11 images. Above
/// 0.8 m/s it is an error or a hand, and left out (sim/statistics/walking.h). So are robots that lie, or are seen for less
/// than 1.7 s. A robot whose name is in `known` is left out.
std::vector<SeenWalk> walks_in(const lab::TruthRecord& truth, const std::vector<std::string>& known,
                               std::size_t recording);

/// The greatest possible speed of one robot, by its top speed: 99 % of its speeds are lower.
struct TopSpeed {
  double value = 0;      // [m/s]
  double deviation = 0;  // [m/s]
};

/// The speeds of robots as the models have them: equally likely between the slowest and the fastest one.
struct PaceFit {
  double forward = 0, forward_low = 0, forward_high = 0;  // [m/s] of the fastest robot, 95 %
  double spread = 0, spread_low = 0, spread_high = 0;     // [0..1] share by which the slowest is slower
};

/// Returns the top speed of a robot. Returns nothing if it walked for less than a minute, or fast for less than a quarter of
/// that: it had no reason to hurry.
std::optional<TopSpeed> top_speed_of(const SeenWalk& walk);

/// Fits the ends of the range to at least five top speeds. The intervals are exact for equally likely speeds (a prior of one
/// over the width), and cover the errors of the speeds.
PaceFit fit_paces(const std::vector<TopSpeed>& tops);

}  // namespace robot::fit
