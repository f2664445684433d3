#include "robot/fit/falling/falling.h"

#include <algorithm>
#include <cmath>

#include "robot/core/text.h"
#include "robot/fit/falling/fall_page.h"
#include "robot/fit/math/counts.h"
#include "robot/fit/math/resampling.h"
#include "sim/statistics/sample.h"

namespace robot::fit {
namespace {

constexpr double kLeastMinutes = 10, kLeastTouching = 60;  // [min], [s] of risk
constexpr std::size_t kFewestTimes = 10;
constexpr double kClustered = 0.2;  // deviation over duration of one attempt, below which one and two are told apart
constexpr double kImage = 1. / 30;  // [s] begin and end are each known to half of it
constexpr std::size_t kSamplesOfTimes = 200;
constexpr double kWidestWalking = 0.2, kWidestTouching = 0.05, kWidestTime = 0.5, kWidestFailure = 0.15;

/// Returns the complete times on the ground [s].
std::vector<double> times_down(const std::vector<FallRisk>& robots) {
  std::vector<double> times;
  for (const FallRisk& robot : robots)
    for (const TrueFall& fall : robot.falls)
      if (fall.down) times.push_back(*fall.down);
  return times;
}

// --- rates ---

void keep_rates(Report& report, const std::string& reason) {
  report.kept.push_back("falls.per_minute_walking: " + reason);
  report.kept.push_back("falls.per_second_touching: " + reason);
}

Figure rate_figure(const char* name, const char* unit, const FallRate& rate, double factor) {
  return {.name = name,
          .unit = unit,
          .value = factor * rate.value,
          .low = factor * rate.low,
          .high = factor * rate.high,
          .kind = "falls"};
}

void add_rates(const FallsSeen& seen, const FallRates& rates, Report& report) {
  const double walking = sum_over(seen.robots, &FallRisk::walking) / 60;
  const double touching = rates.contact * sum_over(seen.robots, &FallRisk::touching);
  const auto of_walking = static_cast<std::size_t>(std::lround(rates.of_walking * static_cast<double>(rates.falls)));
  if (walking >= kLeastMinutes) {
    Figure figure = rate_figure("falls.per_minute_walking", "1/min", rates.walking, 60);
    figure.events = of_walking, figure.recordings = seen.recordings, figure.widest = kWidestWalking;
    figure.domain = {.quantity = "walking", .unit = "min", .from = 0, .to = walking};
    report.needs.push_back(need_of(figure, kWidestWalking / 2, "record more games with the truth's view of falls"));
    report.figures.push_back(std::move(figure));
  } else {
    report.kept.push_back(
        formatted("falls.per_minute_walking: expected at least %.0f minutes of robots that walk, got %.1f",
                  kLeastMinutes, walking));
  }
  if (touching >= kLeastTouching) {
    Figure figure = rate_figure("falls.per_second_touching", "1/s", rates.touching, 1);
    figure.events = rates.falls - of_walking, figure.recordings = seen.recordings, figure.widest = kWidestTouching;
    figure.domain = {.quantity = "contact", .unit = "s", .from = 0, .to = touching};
    report.needs.push_back(need_of(figure, kWidestTouching / 2, "record more games with robots that push each other"));
    report.figures.push_back(std::move(figure));
  } else {
    report.kept.push_back(
        formatted("falls.per_second_touching: expected at least %.0f s of robots in contact, got %.1f s",
                  kLeastTouching, touching));
  }
}

// --- time on the ground ---

/// Returns the mean of durations, of which single long ones hardly count, for some of them.
double robust_mean(const std::vector<double>& values, const std::vector<std::size_t>& chosen, double scale) {
  std::vector<double> drawn;
  for (const std::size_t i : chosen) drawn.push_back(values[i]);
  const auto residuals = [&](const Vector& p, Vector& errors) {
    errors.resize(drawn.size());
    for (std::size_t i = 0; i < drawn.size(); ++i) errors[i] = (drawn[i] - p[0]) / scale;
  };
  return minimise({.least = {0}, .most = {1000}, .residuals = residuals, .loss = Loss::cauchy},
                  {sim::statistics::median(drawn)})
      .parameters[0];
}

/// Returns the figure of a duration that is measured by images or messages, `interval` [s] apart.
Figure duration_figure(const char* name, const std::vector<double>& values, double interval) {
  const double middle = sim::statistics::median(values);
  std::vector<double> errors;
  for (const double value : values) errors.push_back(std::abs(value - middle));
  const double scale = std::max(interval, kOfMedian * sim::statistics::median(errors));
  const auto samples =
      resampled(single_groups(values.size()), kSamplesOfTimes,
                [&](const std::vector<std::size_t>& chosen) -> Vector { return {robust_mean(values, chosen, scale)}; });
  const double value = robust_mean(values, all_of(values.size()), scale);
  // equal durations round alike, so that their mean is no better than one of them: begin and end by half a message
  const double half = two_sided(values.size() - 1) * deviations_of(samples)[0] + interval;
  const auto [least, most] = std::ranges::minmax(values);
  return {.name = name,
          .unit = "s",
          .value = value,
          .low = value - half,
          .high = value + half,
          .events = values.size(),
          .kind = "falls",
          .recordings = {},
          .domain = {.quantity = "duration", .unit = "s", .from = least, .to = most},
          .widest = kWidestTime};
}

void add_duration(const char* name, const std::vector<double>& values, const FallsSeen& seen, Report& report) {
  if (values.size() < kFewestTimes) {
    report.kept.push_back(
        formatted("%s: expected at least %zu complete phases, got %zu", name, kFewestTimes, values.size()));
    report.needs.push_back(need_of(name, "falls", values.size(), 2 * kFewestTimes, "record more games"));
    return;
  }
  Figure figure = duration_figure(name, values, seen.phases.interval);
  figure.recordings = seen.phase_recordings;
  report.figures.push_back(std::move(figure));
}

void add_phases(const FallsSeen& seen, Report& report) {
  const FallPhases& phases = seen.phases;
  add_duration("falls.lying", phases.lying, seen, report);
  add_duration("falls.getting_up", phases.getting_up, seen, report);
  if (phases.attempts < kFewestTimes) {
    report.kept.push_back(
        formatted("falls.failure: expected at least %zu attempts to get up, got %zu", kFewestTimes, phases.attempts));
    return;
  }
  const CountInterval interval = exact_share(phases.failures, phases.attempts);
  report.figures.push_back(
      {.name = "falls.failure",
       .unit = "",
       .value = static_cast<double>(phases.failures) / static_cast<double>(phases.attempts),
       .low = interval.low,
       .high = interval.high,
       .events = phases.attempts,
       .kind = "attempts",
       .recordings = seen.phase_recordings,
       .domain = {.quantity = "attempts", .unit = "", .from = 1, .to = static_cast<double>(phases.attempts)},
       .widest = kWidestFailure});
}

/// Fits the times on the ground of the truth, which do not show the phases.
std::optional<GroundTime> add_times(const FallsSeen& seen, const std::vector<double>& times, Report& report) {
  const std::string alone = "the truth shows only the time on the ground, and no robot recorded its motion status";
  report.kept.push_back("falls.lying: " + alone);
  report.kept.push_back("falls.getting_up: " + alone);
  if (times.size() < kFewestTimes) {
    report.kept.push_back(formatted("falls.failure: expected at least %zu complete times on the ground, got %zu",
                                    kFewestTimes, times.size()));
    return std::nullopt;
  }
  const Group all = all_of(times.size());
  const GroundTime model = fit_ground_time(times, all);
  if (model.deviation > kClustered * model.attempt) {
    report.kept.push_back(
        formatted("falls.failure: times on the ground of one and of several attempts cannot be told apart: expected a "
                  "deviation below "
                  "%.0f %% of one attempt, got %.0f %%",
                  100 * kClustered, 100 * model.deviation / model.attempt));
    return std::nullopt;
  }
  const auto samples = resampled(
      single_groups(times.size()), kSamplesOfTimes / 2,
      [&](const std::vector<std::size_t>& chosen) -> Vector { return {fit_ground_time(times, chosen).attempt}; });
  const double half = two_sided(times.size() - 1) * deviations_of(samples)[0] + kImage;
  std::size_t attempts = 0;
  for (const double time : times)
    attempts += static_cast<std::size_t>(std::clamp(std::lround(time / model.attempt), 1L, 8L));
  const CountInterval share = exact_share(attempts - times.size(), attempts);
  const Domain domain{
      .quantity = "time on the ground", .unit = "s", .from = std::ranges::min(times), .to = std::ranges::max(times)};
  report.figures.push_back({.name = "falls.down",
                            .unit = "s",
                            .value = model.attempt,
                            .low = model.attempt - half,
                            .high = model.attempt + half,
                            .events = times.size(),
                            .kind = "falls",
                            .recordings = seen.recordings,
                            .domain = domain});
  report.figures.push_back({.name = "falls.failure",
                            .unit = "",
                            .value = model.failure,
                            .low = std::min(share.low, model.failure),
                            .high = std::max(share.high, model.failure),
                            .events = attempts,
                            .kind = "attempts",
                            .recordings = seen.recordings,
                            .domain = domain,
                            .widest = kWidestFailure});
  return model;
}

void add_notes(const FallsSeen& seen, const FallRates& rates, std::size_t complete, Report& report) {
  if (seen.unjudged > 0)
    report.notes.push_back(formatted("Left out: %zu recordings whose truth does not judge falls.", seen.unjudged));
  if (rates.unexplained > 0)
    report.notes.push_back(
        formatted("The cause of %zu of %zu falls is not known: the robot neither walked nor touched another one. They "
                  "are shared like the others.",
                  rates.unexplained, falls_of(seen.robots)));
  if (const std::size_t open = falls_of(seen.robots) - complete; open > 0)
    report.notes.push_back(
        formatted("%zu of %zu times on the ground were not seen to their end.", open, falls_of(seen.robots)));
  if (rates.dispersion > 1.5)
    report.notes.push_back(formatted(
        "Robots differ: the falls of a robot vary %.1f times as much as by chance. The intervals allow for it.",
        rates.dispersion));
}

}  // namespace

FallsSeen read_falls(const Evidence& evidence, const RobotSizes& sizes) {
  FallsSeen seen;
  for (const auto& game : evidence.games) {
    auto robots = falls_in(game->record, sizes, seen.recordings.size());
    if (robots.empty()) {
      ++seen.unjudged;
      continue;
    }
    seen.recordings.push_back(game->name);
    std::ranges::move(robots, std::back_inserter(seen.robots));
  }
  for (const WatchedRobot& robot : evidence.robots) {
    const FallPhases phases = read_fall_phases(robot);
    if (phases.lying.empty() && phases.attempts == 0) continue;
    seen.phase_recordings.push_back(robot.name);
    FallPhases& all = seen.phases;
    all.lying.insert(all.lying.end(), phases.lying.begin(), phases.lying.end());
    all.getting_up.insert(all.getting_up.end(), phases.getting_up.begin(), phases.getting_up.end());
    all.attempts += phases.attempts, all.failures += phases.failures;
    all.interval = std::max(all.interval, phases.interval);
  }
  return seen;
}

Report fit_falling(const FallsSeen& seen, const sim::Models& base) {
  Report report;
  report.name = "falls";
  report.title = "How often robots fall, and for how long";
  const FallRates rates = fit_fall_rates(seen.robots);
  const std::vector<double> times = times_down(seen.robots);
  if (seen.robots.empty())
    keep_rates(report, "expected a truth that judges falls, got no such recording");
  else
    add_rates(seen, rates, report);
  std::optional<GroundTime> model;
  if (seen.phase_recordings.empty())
    model = add_times(seen, times, report);
  else
    add_phases(seen, report);
  const double usual = static_cast<double>(base.motion.falls.lying + base.motion.falls.getting_up);
  if (!times.empty()) report.pictures.push_back(picture_of_times(times, model, usual));
  if (rates.falls > 0) report.pictures.push_back(picture_of_rates(seen, rates));
  if (!seen.robots.empty()) report.results.push_back(fall_results(seen));
  add_notes(seen, rates, times.size(), report);
  if (falls_of(seen.robots) > 0) report.tables.emplace_back("falls", table_of_falls(seen));
  if (report.empty())
    report.needs.push_back(need_of("falls.per_minute_walking", "falls", falls_of(seen.robots), 20,
                                   "record games with a truth that judges falls"));
  return report;
}

Report fit_falling(const Evidence& evidence, const sim::Models& base) {
  const RobotSizes sizes{.upright = static_cast<double>(base.contact.robot_radius),
                         .lying = static_cast<double>(base.contact.lying_radius)};
  return fit_falling(read_falls(evidence, sizes), base);
}

}  // namespace robot::fit
