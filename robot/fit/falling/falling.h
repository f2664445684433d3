// How often robots fall, and for how long.
#pragma once

#include "robot/fit/falling/fall_rates.h"
#include "robot/fit/report.h"
#include "sim/match/params.h"

namespace robot::fit {

/// The observations of falls.
struct FallsSeen {
  std::vector<std::string> recordings;  // names of the truths that judge falls, by index
  std::vector<FallRisk> robots;
  FallPhases phases;  // of all robots that recorded them
  std::vector<std::string> phase_recordings;
  std::size_t unjudged = 0;  // truths that judge no falls
};

/// Reads the falls of the truth, and the phases of falls that robots recorded.
FallsSeen read_falls(const Evidence& evidence, const RobotSizes& sizes);

/// Fits falls.per_minute_walking and falls.per_second_touching to the falls of the truth and the time at risk of each robot:
/// the greatest likelihood of both at once. Their intervals are profiles, wider where robots differ. With ten minutes of
/// walking a rate of no falls has an interval, too.
///
/// Fits falls.lying, falls.getting_up and falls.failure to the phases that robots recorded. With the truth alone, the times
/// on the ground give falls.failure and falls.down, the duration of one attempt, where their clusters can be told apart.
/// Fewer than ten complete phases, attempts or times fit nothing.
Report fit_falling(const Evidence& evidence, const sim::Models& base);
Report fit_falling(const FallsSeen& seen, const sim::Models& base);

}  // namespace robot::fit
