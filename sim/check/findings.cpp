#include "sim/check/findings.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "sim/contest/series.h"
#include "sim/match/step.h"

namespace sim::check {

using robot::Result;

namespace {

constexpr double kDeviations = 1.96;  // of a normal distribution, for 95 %

using Values = std::vector<std::optional<double>>;  // by metric

/// Plays one game and measures it.
Values play_one(const Scenario& scenario, const contest::Cast& cast, std::uint64_t seed) {
  const Params& params = cast.params();
  const State start = scenario.openings->begin(params, seed);
  std::vector<Measure> measures;
  measures.reserve(scenario.metrics.size());
  for (const NamedMetric& metric : scenario.metrics) measures.emplace_back(metric.metric);

  State state = start;
  Observer observer(start);
  referee::Events events;
  auto next = scenario.events.begin();
  const Tick end = ticks(static_cast<float>(scenario.seconds));
  for (Tick tick = 0; tick < end && !finished(state) && !cast.failed(); ++tick) {
    for (; next != scenario.events.end() && next->at <= tick; ++next) apply(*next, params, state);
    step(params, state, events);
    const Glance glance = observer.look(state, events);
    for (Measure& measure : measures) measure.see(glance);
  }
  Values values;
  for (const Measure& measure : measures) values.push_back(measure.value());
  return values;
}

bool is_beyond(double value, const NamedMetric& metric) {
  return (metric.at_least && value < *metric.at_least) || (metric.at_most && value > *metric.at_most);
}

Verdict verdict_of(const Finding& finding) {
  const NamedMetric& metric = *finding.metric;
  if (!metric.at_least && !metric.at_most) return Verdict::none;
  if (finding.games == 0) return Verdict::failed;
  if (!is_beyond(finding.mean, metric)) return Verdict::passed;
  const bool is_out = (metric.at_least && finding.interval.high < *metric.at_least) ||
                      (metric.at_most && finding.interval.low > *metric.at_most);
  return is_out ? Verdict::failed : Verdict::unsure;
}

}  // namespace

Interval interval_of_share(int yes, int all) {
  const double n = all, share = yes / n, z2 = kDeviations * kDeviations;
  const double middle = (share + z2 / (2 * n)) / (1 + z2 / n);
  const double half = kDeviations / (1 + z2 / n) * std::sqrt(share * (1 - share) / n + z2 / (4 * n * n));
  // without rounding errors at the ends
  return {yes == 0 ? 0 : middle - half, yes == all ? 1 : middle + half};
}

Interval interval_of_mean(const std::vector<double>& values) {
  const contest::Mean mean = contest::mean_of(values);
  return {mean.mean - kDeviations * mean.error, mean.mean + kDeviations * mean.error};
}

Finding judge(const NamedMetric& metric, const std::vector<double>& values) {
  Finding finding{.metric = &metric, .games = static_cast<int>(values.size()), .interval = {}};
  if (!values.empty()) {
    finding.mean = contest::mean_of(values).mean;
    finding.interval = metric.metric.kind == Metric::Kind::share
                           ? interval_of_share(static_cast<int>(std::ranges::count(values, 1.0)), finding.games)
                           : interval_of_mean(values);
  }
  finding.verdict = verdict_of(finding);
  return finding;
}

Result<std::vector<Finding>> play(const Scenario& scenario, const std::function<void(int)>& progress) {
  std::vector<Values> by_game(static_cast<std::size_t>(scenario.seeds));
  const auto played = contest::for_each_cast(
      *scenario.lineup, 0, scenario.seeds, 0,
      [&](int game, std::uint64_t seed, const contest::Cast& cast) {
        by_game[static_cast<std::size_t>(game)] = play_one(scenario, cast, seed);
      },
      progress);
  if (!played) return played.failure();

  std::vector<Finding> findings;
  for (std::size_t i = 0; i < scenario.metrics.size(); ++i) {
    std::vector<double> values;
    for (const Values& game : by_game)
      if (game[i]) values.push_back(*game[i]);
    findings.push_back(judge(scenario.metrics[i], values));
  }
  return findings;
}

}  // namespace sim::check
