#include "sim/check/findings.h"

#include <algorithm>
#include <cmath>
#include <memory>
#include <optional>

#include "sim/contest/lineup_series.h"

namespace sim::check {

using robot::Result;

namespace {

constexpr double kDeviations = 1.96;  // of a normal distribution, for 95 %

using Values = std::vector<std::optional<double>>;  // by metric

/// One game of a scenario.
class Game {
 public:
  State state;

  Game(const Scenario& scenario, const Params& params, std::uint64_t seed)
      : state(scenario.openings->begin(params, seed)),
        scenario_(scenario),
        params_(params),
        start_(state),
        next_(scenario.events.begin()),
        end_(state.world.tick + ticks(static_cast<float>(scenario.seconds))) {
    measures_.reserve(scenario.metrics.size());
    for (const NamedMetric& metric : scenario.metrics) measures_.emplace_back(metric.metric);
  }

  /// Lets the events of this tick happen.
  bool goes_on() {
    if (state.world.tick >= end_) return false;
    const Tick since = state.world.tick - start_.world.tick;
    for (; next_ != scenario_.events.end() && next_->at <= since; ++next_) apply(*next_, params_, state);
    return true;
  }

  void see(const referee::Events& events) {
    const Glance glance = observer_.look(state, events);
    for (Measure& measure : measures_) measure.see(glance);
  }

  Values values() const {
    Values values;
    for (const Measure& measure : measures_) values.push_back(measure.value());
    return values;
  }

 private:
  const Scenario& scenario_;
  const Params& params_;
  const State start_;
  Observer observer_{start_};
  std::vector<Measure> measures_;
  std::vector<Event>::const_iterator next_;
  const Tick end_;
};

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
  const auto played = contest::play_series(
      *scenario.lineup, {.games = scenario.seeds},
      [&](int, std::uint64_t seed, const contest::Cast& cast) {
        return std::make_unique<Game>(scenario, cast.params(), seed);
      },
      [&](int game, const Game& ended, const contest::Cast&) {
        by_game[static_cast<std::size_t>(game)] = ended.values();
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
