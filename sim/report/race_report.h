// The result of a foresight race, as a table and as JSON.
#pragma once

#include <string>
#include <vector>

#include "sim/foresight/forecast.h"
#include "sim/report/game_report.h"

namespace sim::report {

/// Prints one line per strategy, and the advice as a sentence.
void print_race(const foresight::Forecast& forecast, const foresight::Question& question,
                const std::vector<std::string>& names);

Json race_json(const foresight::Forecast& forecast, const foresight::Question& question,
               const std::vector<std::string>& names);

}  // namespace sim::report
