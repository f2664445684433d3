// What a comparison found, for people and for programs.
#pragma once

#include <string>

#include "sim/app/contest.h"
#include "sim/app/game_report.h"

namespace sim::app {

struct ContestReport {
  const Comparison& comparison;
  const ContestOptions& options;
  const Outcome& outcome;
};

Json to_json(const ContestReport& report);
/// With the decisive pairs and how to see them, where that is asked for.
std::string to_text(const ContestReport& report, bool explain);

/// How many games an answer takes, going by a pilot.
Json plan_json(const ContestReport& pilot);
std::string plan_text(const ContestReport& pilot);

}  // namespace sim::app
