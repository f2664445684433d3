#include "robot/fit/falling/fall_rates.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>

#include "robot/fit/math/simplex.h"
#include "sim/statistics/sample.h"

namespace robot::fit {
namespace {

constexpr double kWithinDoubt = 0.977;  // share of normal errors below two deviations
constexpr double kLeastContact = 0.5;
constexpr double kNinetyFive = 3.841;  // of chi square with one degree of freedom

/// The falls by the state before, and the times at risk [s].
struct FallCounts {
  double walking = 0, touching = 0, both = 0;  // falls
  double walking_time = 0, touching_time = 0;

  FallCounts exchanged() const {
    return {.walking = touching,
            .touching = walking,
            .both = both,
            .walking_time = touching_time,
            .touching_time = walking_time};
  }
};

/// Returns the likeliest other rate for a rate while walking: the root of a quadratic equation.
double other_rate(const FallCounts& counts, double walking) {
  if (counts.touching + counts.both == 0 || counts.touching_time <= 0) return 0;
  const double a = counts.touching_time, b = a * walking - counts.touching - counts.both,
               c = -counts.touching * walking;
  return (-b + std::sqrt(b * b - 4 * a * c)) / (2 * a);
}

double times_log(double count, double rate) { return count > 0 ? count * std::log(rate) : 0; }

double log_likelihood(const FallCounts& counts, double walking, double touching) {
  return times_log(counts.walking, walking) + times_log(counts.touching, touching) +
         times_log(counts.both, walking + touching) - walking * counts.walking_time - touching * counts.touching_time;
}

/// Returns the crossing of a falling function with 0 between two values.
double crossing(double low, double high, const std::function<double(double)>& value) {
  for (int i = 0; i < 100; ++i) {
    const double middle = (low + high) / 2;
    (value(middle) > 0 ? low : high) = middle;
  }
  return (low + high) / 2;
}

/// Returns the rate while walking with the interval of its profile.
FallRate profiled(const FallCounts& counts, double dispersion) {
  if (!(counts.walking_time > 0)) return {.high = INFINITY};
  const double most = (counts.walking + counts.both + 1) / counts.walking_time;
  const auto profile = [&](double rate) { return log_likelihood(counts, rate, other_rate(counts, rate)); };
  // the profile has one summit: its slope is that at the best other rate
  const auto slope = [&](double rate) {
    const double other = other_rate(counts, rate), sum = rate + other;
    return (counts.walking > 0 ? counts.walking / rate : 0) + (counts.both > 0 ? counts.both / sum : 0) -
           counts.walking_time;
  };
  const double tiny = 1e-9 * most;
  const double value = slope(tiny) > 0 ? crossing(tiny, most, slope) : 0;
  const double limit = profile(std::max(value, tiny)) - dispersion * kNinetyFive / 2;
  FallRate rate{.value = value};
  if (value > 0 && profile(tiny) < limit)
    rate.low = crossing(tiny, value, [&](double at) { return limit - profile(at); });
  double beyond = most;
  while (profile(beyond) > limit) beyond *= 2;
  rate.high = crossing(std::max(value, tiny), beyond, [&](double at) { return profile(at) - limit; });
  return rate;
}

FallCounts counts_of(const std::vector<FallRisk>& robots) {
  FallCounts counts;
  for (const FallRisk& robot : robots) {
    counts.walking_time += robot.walking, counts.touching_time += robot.touching;
    for (const TrueFall& fall : robot.falls) {
      if (fall.walking && fall.touching) counts.both += 1;
      if (fall.walking && !fall.touching) counts.walking += 1;
      if (!fall.walking && fall.touching) counts.touching += 1;
    }
  }
  return counts;
}

bool is_explained(const TrueFall& fall) { return fall.walking || fall.touching; }

/// Returns the variance of the falls between robots over that of chance.
double dispersion_of(const std::vector<FallRisk>& robots, double walking, double touching) {
  double sum = 0, count = 0;
  for (const FallRisk& robot : robots) {
    const double expected = walking * robot.walking + touching * robot.touching;
    if (expected < 0.2) continue;  // a single fall would count as much as all others
    const auto falls = static_cast<double>(robot.falls.size());
    sum += (falls - expected) * (falls - expected) / expected, count += 1;
  }
  return count > 4 ? std::max(1., sum / (count - 2)) : 1;
}

constexpr double kOutlier = 0.02;    // share of times that fit no model: a robot that an assistant picks up
constexpr double kLongestDown = 60;  // [s] these are equally likely up to here
constexpr int kMostAttempts = 8;
constexpr double kLeastDeviation = 0.02;  // [s] less than an image

}  // namespace

FallRates fit_fall_rates(const std::vector<FallRisk>& robots) {
  FallCounts counts = counts_of(robots);
  FallRates rates;
  double overlapping = 0;
  for (const FallRisk& robot : robots) {
    const auto explained = static_cast<std::size_t>(std::ranges::count_if(robot.falls, is_explained));
    rates.falls += robot.falls.size(), rates.unexplained += robot.falls.size() - explained;
    overlapping += robot.overlapping;
  }
  if (counts.touching_time > 0)
    rates.contact = std::clamp(2 * kWithinDoubt * overlapping / counts.touching_time, kLeastContact, 1.);
  counts.touching_time *= rates.contact;
  // falls without a cause are shared like the others
  const double explained = counts.walking + counts.touching + counts.both;
  const double factor = explained > 0 ? static_cast<double>(rates.falls) / explained : 1;
  counts.walking *= factor, counts.touching *= factor, counts.both *= factor;
  const double walking = profiled(counts, 1).value, touching = profiled(counts.exchanged(), 1).value;
  rates.dispersion = dispersion_of(robots, walking, touching * rates.contact);
  rates.walking = profiled(counts, rates.dispersion);
  rates.touching = profiled(counts.exchanged(), rates.dispersion);
  const double sum = walking + touching;
  if (sum > 0 && explained > 0)
    rates.of_walking = (counts.walking + counts.both * walking / sum) / (factor * explained);
  return rates;
}

double density_of(const GroundTime& model, double time) {
  double density = kOutlier / kLongestDown, probability = (1 - kOutlier) * (1 - model.failure);
  for (int attempts = 1; attempts <= kMostAttempts; ++attempts, probability *= model.failure) {
    const double deviation = model.deviation * std::sqrt(attempts), z = (time - attempts * model.attempt) / deviation;
    density += probability * std::exp(-z * z / 2) / (deviation * std::sqrt(2 * std::numbers::pi));
  }
  return density;
}

GroundTime fit_ground_time(const std::vector<double>& times, const std::vector<std::size_t>& chosen) {
  std::vector<double> values;
  for (const std::size_t i : chosen) values.push_back(times[i]);
  const auto model_of = [](const Vector& p) {
    return GroundTime{.attempt = p[0], .deviation = std::exp(p[1]), .failure = p[2]};
  };
  const auto unlikely = [&](const Vector& p) {
    const GroundTime model = model_of(p);
    if (model.attempt < 0.3 || model.attempt > kLongestDown || model.deviation < kLeastDeviation ||
        model.deviation > model.attempt || model.failure < 0 || model.failure > 0.95)
      return static_cast<double>(INFINITY);
    double sum = 0;
    for (const double time : values) sum -= std::log(density_of(model, time));
    return sum;
  };
  GroundTime best;
  double least = INFINITY;
  for (const double start : {0.1, 0.3, 0.5}) {  // most times may be those of one attempt, or of several
    const double attempt = std::max(0.4, sim::statistics::quantile(values, start));
    const Vector found = least_of(unlikely, {attempt, std::log(0.1 * attempt), 0.2}, {0.1 * attempt, 0.5, 0.1});
    if (const double cost = unlikely(found); cost < least) least = cost, best = model_of(found);
  }
  return best;
}

}  // namespace robot::fit
