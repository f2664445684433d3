// The result of a comparison as text and JSON.
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

/// Returns the verdict in one sentence.
std::string sentence_of(const ContestReport& report);

/// Returns everything except the figures that depend on the machine.
Json to_json(const ContestReport& report);
/// Returns everything, with the duration and the cost of a decision.
Json to_whole_json(const ContestReport& report);
/// Returns the text, with `explain` also the decisive pairs and the commands that show them.
std::string to_text(const ContestReport& report, bool explain);

/// Return the number of games for an answer, estimated from a pilot run.
Json plan_json(const ContestReport& pilot);
std::string plan_text(const ContestReport& pilot);

}  // namespace sim::report
