// The pictures and tables of robots that are seen from outside.
#pragma once

#include <cstddef>
#include <vector>

#include "robot/fit/opponents/opponents.h"

namespace robot::fit {

inline constexpr double kWalksFrom = 0.05;  // [m/s] a slower robot stands (sim/statistics/walking.h)

/// Returns the number of the speeds [m/s] of a robot that walks.
std::size_t walking_speeds(const std::vector<double>& speeds);

/// Draws a histogram of the speeds [m/s] of robots that walk. `fast` is faster than 99 % of all speeds, `usual` that of the models.
Picture picture_of_speeds(const std::vector<double>& speeds, double fast, double usual);

/// Draws a histogram of the speeds of kicks with their median `middle` [m/s].
Picture picture_of_kicks(const std::vector<SeenKick>& kicks, double middle);

Results results_of_teams(const OpponentsSeen& seen);
Table table_of_kicks(const OpponentsSeen& seen);
Table table_of_walks(const OpponentsSeen& seen);

}  // namespace robot::fit
