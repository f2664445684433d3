// The outcome of a comparison, as text and as JSON.
#pragma once

#include <string>

#include "sim/contest/contest.h"
#include "sim/report/game_report.h"

namespace sim::report {

/// A comparison with its outcome. The three objects must outlive it.
struct ContestReport {
  const contest::Comparison& comparison;
  const contest::ContestOptions& options;
  const contest::Outcome& outcome;
};

/// Returns the verdict in one sentence.
std::string sentence_of(const ContestReport& report);

/// Returns how many games the same interval takes without pairs: "7 % fewer games" for a pairing gain of 0.93.
std::string games_without_pairs(double pairing_gain);

/// Returns the report without figures that depend on the machine.
Json to_json(const ContestReport& report);
/// Returns to_json() and the figures of this machine: the duration and the cost of a decision.
Json to_whole_json(const ContestReport& report);
/// Returns the report as text. With `explain` it lists the decisive pairs and the commands that replay them.
std::string to_text(const ContestReport& report, bool explain);

}  // namespace sim::report
