// The pictures and tables of falls.
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "robot/fit/falling/falling.h"

namespace robot::fit {

double sum_over(const std::vector<FallRisk>& robots, double FallRisk::*time);
std::size_t falls_of(const std::vector<FallRisk>& robots);

/// Draws the falls of each robot over those that its time at risk lets expect.
Picture picture_of_rates(const FallsSeen& seen, const FallRates& rates);

/// Draws a histogram of the times on the ground [s], at least one, and the fitted ones. `usual` [s] is one attempt of the models.
Picture picture_of_times(const std::vector<double>& times, const std::optional<GroundTime>& model, double usual);

Table table_of_falls(const FallsSeen& seen);

/// Returns the time at risk and the falls of each recording.
Results fall_results(const FallsSeen& seen);

}  // namespace robot::fit
