#include <algorithm>
#include <cmath>
#include <cstdint>
#include <random>

#include "robot/core/text.h"
#include "robot/fit/checking/checks.h"
#include "robot/fit/falling/fall_page.h"
#include "robot/fit/math/resampling.h"
#include "sim/statistics/sample.h"

namespace robot::fit {
namespace {

constexpr std::size_t kFewestCheckedRolls = 5, kFewestAttempts = 5;
constexpr double kLeastRisk = 300;      // [s] of walking or touching
constexpr double kRollError = 0.002;    // [m/s²] of a parabola through places of whole ticks
constexpr double kWiderMedian = 1.25;   // deviation of a median of normal values over that of their mean
constexpr double kTickError = 1. / 30;  // [s] of a duration

/// Returns the spread of values by the median of their distances from the median, one standard deviation.
double spread_by_median(std::vector<double> values) {
  const double middle = lab::median_of(values);
  for (double& value : values) value = std::abs(value - middle);
  return kOfMedian * lab::median_of(std::move(values));
}

/// Returns the statistic of durations [s]. The models have one duration; its spread is that of the recording.
Statistic duration_of(const char* name, const std::vector<double>& seen, double model, double interval,
                      std::uint64_t seed) {
  Statistic statistic{.name = name,
                      .unit = "s",
                      .recorded = sim::statistics::median(seen),
                      .simulated = {},
                      .events = seen.size(),
                      .kind = "falls"};
  // begin and end are each known to half the time between two messages
  const double one = std::hypot(spread_by_median(seen), interval / std::sqrt(6.));
  const double of_median = kWiderMedian * one / std::sqrt(static_cast<double>(seen.size()));
  std::mt19937_64 random(seed);
  std::normal_distribution<double> normal(model, std::hypot(of_median, kTickError));
  for (std::size_t i = 0; i < kCheckSamples; ++i) statistic.simulated.push_back(normal(random));
  return statistic;
}

void check_phases(const FallPhases& phases, const sim::motion::Falls& falls, std::vector<Statistic>& all,
                  std::vector<std::string>& missing) {
  if (phases.attempts < kFewestAttempts) {
    missing.push_back(formatted("getting up: expected at least %zu attempts in the status of robots, got %zu",
                                kFewestAttempts, phases.attempts));
    return;
  }
  if (phases.lying.size() >= kFewestAttempts)
    all.push_back(duration_of("falls: median time lying", phases.lying, falls.lying, phases.interval, 2));
  if (phases.getting_up.size() >= kFewestAttempts)
    all.push_back(duration_of("falls: median time of an attempt to get up", phases.getting_up, falls.getting_up,
                              phases.interval, 3));
  Statistic failures{.name = "falls: failed attempts to get up",
                     .unit = "",
                     .recorded = static_cast<double>(phases.failures),
                     .simulated = {},
                     .events = phases.attempts,
                     .kind = "attempts"};
  std::mt19937_64 random(4);
  std::binomial_distribution<int> failed(static_cast<int>(phases.attempts), falls.failure);
  for (std::size_t i = 0; i < kCheckSamples; ++i) failures.simulated.push_back(failed(random));
  all.push_back(std::move(failures));
}

}  // namespace

std::vector<Statistic> check_rolls(const std::vector<Roll>& rolls, const sim::Models& models,
                                   std::vector<std::string>& missing) {
  if (rolls.size() < kFewestCheckedRolls) {
    missing.push_back(formatted("rolling: expected at least %zu free rolls of half a second, got %zu",
                                kFewestCheckedRolls, rolls.size()));
    return {};
  }
  std::vector<double> values;
  for (const Roll& roll : rolls) values.push_back(roll.deceleration);
  Statistic middle{.name = "rolling: median deceleration",
                   .unit = "m/s²",
                   .recorded = sim::statistics::median(values),
                   .simulated = {},
                   .events = rolls.size(),
                   .kind = "rolls"};
  // the models have no spread between rolls, so that of the recording counts where it is more than their errors
  std::vector<double> deviations;
  for (const Roll& roll : rolls) deviations.push_back(roll.deviation);
  const double all = spread_by_median(values), errors = lab::median_of(deviations);
  const double spread = std::sqrt(std::max(0., all * all - errors * errors));
  std::mt19937_64 random(5);
  std::normal_distribution<double> normal;
  for (std::size_t i = 0; i < kCheckSamples; ++i) {
    for (std::size_t k = 0; k < rolls.size(); ++k)
      values[k] = models.ball.deceleration + std::hypot(deviations[k], spread) * normal(random);
    middle.simulated.push_back(lab::median_of(values) + kRollError * normal(random));
  }
  return {middle};
}

std::vector<Statistic> check_falls(const FallsSeen& seen, const sim::Models& models,
                                   std::vector<std::string>& missing) {
  std::vector<Statistic> all;
  const sim::motion::Falls& falls = models.motion.falls;
  const double walking = sum_over(seen.robots, &FallRisk::walking);
  const double touching = sum_over(seen.robots, &FallRisk::touching);
  if (models.effects.falls && falls.table.given) {
    missing.push_back("falls: the models have a table of falls, and a recording does not tell how hard robots collide");
  } else if (walking + touching >= kLeastRisk) {
    const double contact = fit_fall_rates(seen.robots).contact;
    const double expected =
        models.effects.falls ? falls.per_minute_walking / 60 * walking + falls.per_second_touching * contact * touching
                             : 0;
    Statistic count{.name = "falls: number",
                    .unit = "",
                    .recorded = static_cast<double>(falls_of(seen.robots)),
                    .simulated = {},
                    .events = falls_of(seen.robots),
                    .kind = "falls"};
    std::mt19937_64 random(6);
    std::poisson_distribution<int> drawn(std::max(1e-9, expected));
    for (std::size_t i = 0; i < kCheckSamples; ++i) count.simulated.push_back(drawn(random));
    all.push_back(std::move(count));
  } else {
    missing.push_back(
        formatted("falls: expected at least %.0f s of robots that walk or touch in a truth that judges falls, got %.0f",
                  kLeastRisk, walking + touching));
  }
  check_phases(seen.phases, falls, all, missing);
  return all;
}

}  // namespace robot::fit
