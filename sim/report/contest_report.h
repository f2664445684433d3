// What a comparison found, for people and for programs.
#pragma once

#include <string>

#include "sim/contest/contest.h"
#include "sim/report/game_report.h"

namespace sim::report {

struct ContestReport {
  const contest::Comparison& comparison;
  const contest::ContestOptions& options;
  const contest::Outcome& outcome;
};

/// The verdict in one sentence.
std::string sentence_of(const ContestReport& report);

/// All of it but what hangs on the machine.
Json to_json(const ContestReport& report);
/// With that: how long it took, and what a decision costs.
Json to_whole_json(const ContestReport& report);
/// With the decisive pairs and how to see them, where that is asked for.
std::string to_text(const ContestReport& report, bool explain);

/// How many games an answer takes, going by a pilot.
Json plan_json(const ContestReport& pilot);
std::string plan_text(const ContestReport& pilot);

}  // namespace sim::report
