// A verdict under other models: does it depend on the robots?
#pragma once

#include <string>
#include <vector>

#include "sim/contest/contest.h"
#include "sim/report/contest_report.h"

namespace sim::report {

/// The result under one condition.
struct UnderConditions {
  std::string conditions;  // such as "walk x0.8"; empty: unchanged models
  compare::Verdict verdict = compare::Verdict::undecided;
  compare::Interval gain;
  std::int64_t pairs = 0;
};

/// Returns the conditions that change the verdict. The unchanged models are the first of the list.
std::vector<std::string> turned_by(const std::vector<UnderConditions>& found);

/// Returns a sentence such as "passing against baseline: better throughout, under all 7 models".
std::string robust_sentence(const contest::ComparisonChoice& choice, const std::vector<UnderConditions>& found);

Json robust_json(const contest::ComparisonChoice& choice, const std::vector<UnderConditions>& found);
std::string robust_text(const contest::ComparisonChoice& choice, const std::vector<UnderConditions>& found);

}  // namespace sim::report
