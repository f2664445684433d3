#include <algorithm>
#include <cmath>
#include <random>

#include "robot/core/text.h"
#include "robot/fit/checking/checks.h"
#include "robot/fit/math/angles.h"
#include "robot/fit/math/resampling.h"
#include "sim/statistics/sample.h"

namespace robot::fit {
namespace {

constexpr std::size_t kFewestChecked = 5, kMostDraws = 1000;
constexpr double kFarQuantile = 0.9;
constexpr double kMostRanges = 2;  // a kick that was tracked wrong counts as two ranges of its kind at most

/// Draws kicks of a model with the errors of observation of given ones.
class KickDraw {
 public:
  KickDraw(const sim::motion::Kick& kick, const sim::Models& models, double slowest)
      : speed_(std::sqrt(2 * static_cast<double>(models.ball.deceleration) * kick.range)),
        direction_(kick.direction),
        range_deviation_(models.effects.kick_noise ? kick.range_deviation : 0),
        direction_deviation_(models.effects.kick_noise ? kick.direction_deviation : 0),
        partial_(models.effects.partial_hits ? models.motion.hits.partial : 0),
        spread_(models.motion.hits.spread),
        slowest_(slowest) {}

  TrackedKick like(const TrackedKick& seen) {
    TrackedKick kick = seen;
    for (std::size_t i = 0; i < kMostDraws; ++i) {
      const double share = uniform_(random_) < partial_ ? uniform_(random_) : 1;
      const double range = std::max(0., 1 + range_deviation_ * normal_(random_));
      kick.speed = share * speed_ * std::sqrt(range) + seen.speed_deviation * normal_(random_);
      const double deviation = (spread_ - (spread_ - 1) * share) * direction_deviation_;
      kick.direction = direction_ + deviation * normal_(random_) + seen.direction_deviation * normal_(random_);
      if (kick.speed >= slowest_) return kick;
    }
    kick.speed = slowest_;
    return kick;
  }

 private:
  const double speed_, direction_, range_deviation_, direction_deviation_, partial_, spread_, slowest_;
  std::mt19937_64 random_{1};
  std::normal_distribution<double> normal_;
  std::uniform_real_distribution<double> uniform_;
};

/// The statistics of kicks of one kind.
struct KickNumbers {
  double mean = 0, far = 0;             // [m] of the landing distance
  double direction = 0, deviation = 0;  // [rad]
};

/// Returns the numbers of kicks, at least one.
KickNumbers numbers_of(const std::vector<TrackedKick>& kicks, const sim::motion::Kick& kind, double deceleration) {
  const double around = kind.direction;
  KickNumbers numbers;
  std::vector<double> distances, angles;
  for (const TrackedKick& kick : kicks) {
    distances.push_back(std::min(kick.speed * kick.speed / (2 * deceleration), kMostRanges * kind.range));
    numbers.mean += distances.back() / static_cast<double>(kicks.size());
    angles.push_back(wrapped(kick.direction - around));
  }
  numbers.far = sim::statistics::quantile(std::move(distances), kFarQuantile);
  const double middle = lab::median_of(angles);
  for (double& angle : angles) angle = std::abs(angle - middle);
  numbers.direction = around + middle;
  numbers.deviation = kOfMedian * lab::median_of(std::move(angles));
  return numbers;
}

void add_kind(const KickFit& seen, const sim::motion::Kick& kick, const sim::Models& models,
              std::vector<Statistic>& all) {
  const double deceleration = models.ball.deceleration;
  const KickNumbers recorded = numbers_of(seen.kicks, kick, deceleration);
  const auto named = [&](const char* what, const char* unit, double value) {
    return Statistic{.name = "kick " + seen.kind + ": " + what,
                     .unit = unit,
                     .recorded = value,
                     .simulated = {},
                     .events = seen.kicks.size(),
                     .kind = "kicks"};
  };
  Statistic mean = named("mean distance", "m", recorded.mean);
  Statistic far = named("90 % of distances are below", "m", recorded.far);
  Statistic direction = named("median direction", "rad", recorded.direction);
  Statistic deviation = named("deviation of directions", "rad", recorded.deviation);
  KickDraw draw(kick, models, seen.slowest);
  std::vector<TrackedKick> drawn(seen.kicks.size());
  for (std::size_t i = 0; i < kCheckSamples; ++i) {
    for (std::size_t k = 0; k < drawn.size(); ++k) drawn[k] = draw.like(seen.kicks[k]);
    const KickNumbers numbers = numbers_of(drawn, kick, deceleration);
    mean.simulated.push_back(numbers.mean), far.simulated.push_back(numbers.far);
    direction.simulated.push_back(numbers.direction), deviation.simulated.push_back(numbers.deviation);
  }
  for (Statistic* one : {&mean, &far, &direction, &deviation}) all.push_back(std::move(*one));
}

}  // namespace

std::vector<Statistic> check_kicks(const std::vector<KickFit>& seen, const sim::Models& models,
                                   std::vector<std::string>& missing) {
  std::vector<Statistic> all;
  for (int i = 0; i < models.motion.kick_count; ++i) {
    const sim::motion::Kick& kick = models.motion.kicks[i];
    const auto found = std::ranges::find(seen, kick.name, &KickFit::kind);
    KickFit counted{.kind = kick.name, .kicks = {}, .model = {}, .figures = {}, .partial = {}};
    if (found != seen.end()) counted = *found;
    std::erase_if(counted.kicks, [&](const TrackedKick& one) {
      return !(one.speed >= counted.slowest) || !std::isfinite(one.speed + one.direction);
    });
    if (counted.kicks.size() >= kFewestChecked)
      add_kind(counted, kick, models, all);
    else
      missing.push_back(formatted("kick %s: expected at least %zu kicks in place that nobody disturbs, got %zu",
                                  kick.name, kFewestChecked, counted.kicks.size()));
  }
  return all;
}

}  // namespace robot::fit
