#include "robot/fit/kicks/kick_model.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "robot/fit/math/angles.h"
#include "robot/fit/math/simplex.h"

namespace robot::fit {
namespace {

constexpr double kLeastPartial = 1e-3;  // a probability that no number of kicks tells from 0
constexpr double kLeastDensity = 1e-4;  // of any kick: a single one that fits nothing hardly counts

double normal(double distance, double deviation) {
  const double z = distance / deviation;
  return std::exp(-z * z / 2) / (deviation * std::sqrt(2 * std::numbers::pi));
}

/// The share of a normal distribution below a number of standard deviations.
double below(double z) { return std::erfc(-z / std::numbers::sqrt2) / 2; }

Vector vector_of(const KickModel& model) {
  return {model.speed, model.range_deviation, model.direction, model.direction_deviation, model.partial};
}

KickModel model_of(const Vector& p) {
  return {.speed = p[0], .range_deviation = p[1], .direction = p[2], .direction_deviation = p[3], .partial = p[4]};
}

bool is_possible(const KickModel& model) {
  return model.speed > 0.05 && model.speed < 8 && model.range_deviation > 0.005 &&
         model.range_deviation < kMostRangeDeviation && model.direction_deviation > 0.002 &&
         model.direction_deviation < 1 && model.partial >= 0 && model.partial <= 1;
}

/// A summit of the likelihood.
struct Summit {
  KickModel model;
  double unlikely = INFINITY;  // minus the logarithm of the likelihood
};

/// Returns minus the logarithm of a kick's likelihood.
double unlikelihood(const TrackedKick& kick, const KickModel& model, const KickSight& sight) {
  return -std::log(kLeastDensity + model.density(kick, sight.spread, sight.slowest));
}

/// Climbs from a start. The probability of partial hits may be fixed.
Summit climbed(const std::vector<TrackedKick>& kicks, const std::vector<std::size_t>& chosen, const KickSight& sight,
               const KickModel& start, bool fixes_partial = false) {
  const auto unlikely = [&](const Vector& p) {
    const KickModel model = model_of(p);
    if (!is_possible(model)) return static_cast<double>(INFINITY);
    double sum = 0;
    for (const std::size_t i : chosen) sum += unlikelihood(kicks[i], model, sight);
    return sum;
  };
  const double inwards = start.partial > 0.5 ? -0.08 : 0.08, aside = fixes_partial ? 0 : inwards;
  const Vector found = least_of(unlikely, vector_of(start), {-0.1 * start.speed, 0.08, 0.05, 0.05, aside});
  Summit summit{.model = model_of(found), .unlikely = unlikely(found)};
  if (summit.model.partial < kLeastPartial && !fixes_partial) summit.model.partial = 0;
  return summit;
}

}  // namespace

double KickModel::density(const TrackedKick& kick, double spread, double slowest) const {
  // the range grows with the square of the speed; the error of the speed adds to its deviation
  const double square = kick.speed * kick.speed / (speed * speed);
  const double sigma = std::hypot(range_deviation, 2 * kick.speed_deviation / speed);
  const auto direction_density = [&](double factor) {
    return normal(wrapped(kick.direction - direction),
                  std::hypot(factor * direction_deviation, kick.direction_deviation));
  };
  const double full = normal(square - 1, sigma) * 2 * kick.speed / (speed * speed) * direction_density(1);
  const double share = std::min(1., kick.speed / speed);
  const double part = below((1 - square) / sigma) / speed * direction_density(spread - (spread - 1) * share);
  const double seen = 1 - partial * std::min(0.99, slowest / speed);
  return ((1 - partial) * full + partial * part) / seen;
}

KickModel fit_kick(const std::vector<TrackedKick>& kicks, const std::vector<std::size_t>& chosen,
                   const KickSight& sight) {
  std::vector<double> speeds, directions;
  for (const std::size_t i : chosen) {
    speeds.push_back(kicks[i].speed);
    directions.push_back(kicks[i].direction);
  }
  std::ranges::sort(speeds);
  std::ranges::sort(directions);
  // the likelihood may have a summit for mostly full hits and one for mostly partial ones
  Summit best;
  for (const double partial : {0.1, 0.5, 0.9}) {
    const double rank = partial < 0.3 ? 0.5 : 0.9;
    const KickModel start{.speed = speeds[static_cast<std::size_t>(rank * static_cast<double>(speeds.size() - 1))],
                          .range_deviation = 0.15,
                          .direction = directions[directions.size() / 2],
                          .direction_deviation = 0.1,
                          .partial = partial};
    if (const Summit found = climbed(kicks, chosen, sight, start); found.unlikely < best.unlikely) best = found;
  }
  return best.model;
}

PartialInterval partial_interval(const std::vector<TrackedKick>& kicks, const std::vector<std::size_t>& chosen,
                                 const KickSight& sight, const KickModel& fitted) {
  constexpr double kStep = 0.01, kHalfOfChiSquare = 1.92;  // of one parameter, 95 %
  const double best = climbed(kicks, chosen, sight, fitted, true).unlikely;
  const auto end = [&](double step) {
    KickModel model = fitted;
    while (model.partial + step >= 0 && model.partial + step <= 1) {
      model.partial += step;
      const Summit there = climbed(kicks, chosen, sight, model, true);
      if (there.unlikely > best + kHalfOfChiSquare) return model.partial;
      model = there.model;
    }
    return step < 0 ? 0. : 1.;
  };
  return {.low = end(-kStep), .high = end(kStep)};
}

KickModel refit_kick(const std::vector<TrackedKick>& kicks, const std::vector<std::size_t>& chosen,
                     const KickSight& sight, const KickModel& near) {
  return climbed(kicks, chosen, sight, near).model;
}

double likeliest_speed(const std::vector<TrackedKick>& kicks, const KickModel& model, const KickSight& sight) {
  constexpr double kFactor = 2.5, kCoarse = 1.08, kFine = 1.01;  // the likelihood may have several summits
  double least = INFINITY, best = model.speed;
  const auto search = [&](double from, double to, double factor) {
    for (KickModel one = model; from <= to; from *= factor) {
      one.speed = from;
      double sum = 0;
      for (const TrackedKick& kick : kicks) sum += unlikelihood(kick, one, sight);
      if (sum < least) least = sum, best = from;
    }
  };
  search(model.speed / kFactor, model.speed * kFactor, kCoarse);
  search(best / kCoarse, best * kCoarse, kFine);
  return best;
}

}  // namespace robot::fit
