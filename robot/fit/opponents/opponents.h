// The abilities of robots that recorded nothing themselves, seen from outside.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "robot/fit/opponents/walks.h"
#include "robot/fit/report.h"
#include "sim/match/params.h"

namespace robot::fit {

/// A kick of a robot that recorded nothing.
struct SeenKick {
  std::size_t recording = 0;
  double at = 0;     // [s] since the epoch of the truth
  std::string team;  // of the robot; empty if it is not identified
  double speed = 0;  // [m/s] of the ball just after it
  double reach = 0;  // [m] that the ball then rolls
};

/// The observations of robots from outside.
struct OpponentsSeen {
  std::vector<std::string> recordings;  // names of the truths, by index
  std::vector<SeenWalk> walks;
  std::vector<SeenKick> kicks;
  bool all_unknown = true;  // no robot recorded anything itself
};

/// Reads the walks and kicks of all robots of the truth that recorded nothing. A kick makes a ball faster than 0.5 m/s that was
/// slower than half of that speed, within 0.35 m of a robot. `deceleration` [m/s²] is that of the ball.
OpponentsSeen read_opponents(const Evidence& evidence, double deceleration);

/// Fits the figures of robots that recorded nothing. 99 % of all speeds are below opponents.speed; opponents.speed_median is that of
/// robots that walk. opponents.kick_speed is the median of kicks; 90 % of them roll less far than opponents.reach. Their intervals resample
/// kicks, and whole robots or, of fewer than ten robots, blocks of 20 s. Fewer than 60 s of walking or 15 kicks fit nothing.
///
/// If no robot recorded anything, also walk.forward and walk.spread, from the top speeds of at least five robots. They
/// are speeds that were seen: a team that never hurries looks slow.
Report fit_opponents(const Evidence& evidence, const sim::Models& base);
Report fit_opponents(const OpponentsSeen& seen, const sim::Models& base);

}  // namespace robot::fit
