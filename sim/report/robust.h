// A verdict repeated under other models: does it depend on the models of the robots?
#pragma once

#include <string>
#include <vector>

#include "sim/contest/contest.h"
#include "sim/report/contest_report.h"

namespace sim::report {

/// The outcome under one of the conditions.
struct UnderConditions {
  std::string conditions;  // "walk x0.8"; empty: the models as they are
  compare::Verdict verdict = compare::Verdict::undecided;
  compare::Interval gain;
  std::int64_t pairs = 0;
};

/// Returns the conditions with another verdict than the first of the list, the models as they are.
std::vector<std::string> turned_by(const std::vector<UnderConditions>& found);

/// "passing is better than baseline throughout: under all 7 models", "… under these models, but not with walk x0.8".
std::string robust_sentence(const contest::ComparisonChoice& choice, const std::vector<UnderConditions>& found);

Json robust_json(const contest::ComparisonChoice& choice, const std::vector<UnderConditions>& found);
std::string robust_text(const contest::ComparisonChoice& choice, const std::vector<UnderConditions>& found);

}  // namespace sim::report
