#include "robot/fit/checking/statistic.h"

#include <algorithm>
#include <cmath>

#include "sim/statistics/sample.h"

namespace robot::fit {
namespace {

constexpr double kMissedAtOnce = 0.05;  // share of recordings in which right models miss a statistic

}  // namespace

double Verdict::distance(double recorded) const {
  const double half = recorded < middle ? middle - low : high - middle;
  if (half > 0) return (recorded - middle) / half;
  return recorded == middle ? 0 : std::copysign(INFINITY, recorded - middle);
}

std::vector<Verdict> judge(const std::vector<Statistic>& statistics) {
  std::vector<Verdict> verdicts;
  const double tail = kMissedAtOnce / static_cast<double>(std::max<std::size_t>(1, statistics.size())) / 2;
  for (const Statistic& statistic : statistics) {
    Verdict verdict{.middle = sim::statistics::median(statistic.simulated),
                    .low = sim::statistics::quantile(statistic.simulated, tail),
                    .high = sim::statistics::quantile(statistic.simulated, 1 - tail)};
    verdict.inside = statistic.recorded >= verdict.low && statistic.recorded <= verdict.high;
    verdicts.push_back(verdict);
  }
  return verdicts;
}

}  // namespace robot::fit
