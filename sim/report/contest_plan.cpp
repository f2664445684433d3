#include "sim/report/contest_plan.h"

#include <algorithm>
#include <cmath>

#include "robot/core/json_library.h"
#include "robot/core/text.h"

namespace sim::report {
namespace {

using robot::formatted;

struct Needed {
  double delta, variance, seconds_per_pair;
  compare::Plan plan;
};

Needed needed_by(const ContestReport& pilot) {
  const double variance = compare::pair_variance(pilot.outcome.tally, pilot.comparison.unit());
  const compare::Hypothesis question =
      compare::asked(pilot.options.question, pilot.outcome.tally, pilot.comparison.unit());
  compare::Plan plan = compare::plan(variance, question.h1 - question.h0);
  // the sequential test gives no answer before this number of pairs
  const auto fewest = static_cast<double>(question.fewest_pairs);
  for (double* const pairs : {&plan.sequential, &plan.sequential_worst}) *pairs = std::max(*pairs, fewest);
  return {.delta = question.h1 - question.h0,
          .variance = variance,
          .seconds_per_pair =
              pilot.outcome.seconds / static_cast<double>(std::max<std::int64_t>(1, pilot.outcome.tally.pairs)),
          .plan = plan};
}

}  // namespace

Json plan_json(const ContestReport& pilot) {
  const auto [delta, variance, seconds, plan] = needed_by(pilot);
  const auto entry = [seconds = seconds](double pairs) {
    return Json{{"games", 2 * std::ceil(pairs)}, {"seconds", pairs * seconds}};
  };
  return {{"delta", delta},
          {"pilot_pairs", pilot.outcome.tally.pairs},
          {"pair_variance", variance},
          {"fixed_80", entry(plan.fixed_80)},
          {"fixed_95", entry(plan.fixed_95)},
          {"sequential", entry(plan.sequential)},
          {"sequential_worst", entry(plan.sequential_worst)}};
}

std::string plan_text(const ContestReport& pilot) {
  const auto [delta, variance, seconds, plan] = needed_by(pilot);
  std::string out = formatted("to tell a gain of %.3g per game from none (a pilot of %lld pairs, variance %.3g):\n\n",
                              delta, static_cast<long long>(pilot.outcome.tally.pairs), variance);
  const auto line = [&out, seconds = seconds](const char* what, double pairs) {
    out += formatted("  %-52s%9.0f games%9.1f min\n", what, 2 * std::ceil(pairs), pairs * seconds / 60);
  };
  line("sequential test, where one of its answers is true", plan.sequential);
  line("sequential test, where the truth lies between them", plan.sequential_worst);
  line("fixed number, found in 80 % of runs", plan.fixed_80);
  line("fixed number, found in 95 % of runs", plan.fixed_95);
  return out;
}

}  // namespace sim::report
