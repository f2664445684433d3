// What foresight says, as a table for people and as JSON.
#pragma once

#include <string>
#include <vector>

#include "sim/app/game_report.h"
#include "sim/foresight/forecast.h"

namespace sim::app {

/// One line per strategy, and the advice in a sentence.
void print_race(const foresight::Forecast& forecast, const foresight::Question& question,
                const std::vector<std::string>& names);

Json race_json(const foresight::Forecast& forecast, const foresight::Question& question,
               const std::vector<std::string>& names);

}  // namespace sim::app
