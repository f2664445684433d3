#include <algorithm>
#include <cmath>
#include <random>

#include "robot/core/text.h"
#include "robot/fit/checking/checks.h"
#include "robot/fit/math/angles.h"
#include "robot/fit/math/resampling.h"

namespace robot::fit {
namespace {

constexpr std::size_t kFewestChecked = 5, kMostDraws = 1000;
constexpr double kMostRanges = 2;  // a kick that was tracked wrong counts as two ranges of its kind at most

KickModel kick_model_of(const sim::motion::Kick& kick, const sim::Models& models) {
  const bool noisy = models.effects.kick_noise;
  return {.speed = std::sqrt(2 * static_cast<double>(models.ball.deceleration) * kick.range),
          .range_deviation = noisy ? kick.range_deviation : 0,
          .direction = kick.direction,
          .direction_deviation = noisy ? kick.direction_deviation : 0,
          .partial = models.effects.partial_hits ? models.motion.hits.partial : 0};
}

/// Draws kicks of a model with the errors of observation of given ones.
class KickDraw {
 public:
  KickDraw(const KickModel& model, const KickSight& sight) : model_(model), sight_(sight) {}

  TrackedKick like(const TrackedKick& seen) {
    TrackedKick kick = seen;
    for (std::size_t i = 0; i < kMostDraws; ++i) {
      const double share = uniform_(random_) < model_.partial ? uniform_(random_) : 1;
      const double range = std::max(0., 1 + model_.range_deviation * normal_(random_));
      kick.speed = share * model_.speed * std::sqrt(range) + seen.speed_deviation * normal_(random_);
      const double deviation = (sight_.spread - (sight_.spread - 1) * share) * model_.direction_deviation;
      kick.direction = model_.direction + deviation * normal_(random_) + seen.direction_deviation * normal_(random_);
      if (kick.speed >= sight_.slowest) return kick;
    }
    kick.speed = sight_.slowest;
    return kick;
  }

 private:
  const KickModel model_;
  const KickSight sight_;
  std::mt19937_64 random_{1};
  std::normal_distribution<double> normal_;
  std::uniform_real_distribution<double> uniform_;
};

/// The statistics of kicks of one kind.
struct KickNumbers {
  double mean = 0;                      // [m] of the landing distance
  double range = 0;                     // [m] likeliest of a full hit: partial hits move the mean, but hardly this
  double direction = 0, deviation = 0;  // [rad]
};

/// Returns the numbers of kicks, at least one. `model` is the checked one.
KickNumbers numbers_of(const std::vector<TrackedKick>& kicks, const KickModel& model, const KickSight& sight,
                       double deceleration) {
  const auto distance_of = [&](double speed) { return speed * speed / (2 * deceleration); };
  const double farthest = kMostRanges * distance_of(model.speed);
  KickNumbers numbers;
  std::vector<double> angles;
  for (const TrackedKick& kick : kicks) {
    numbers.mean += std::min(distance_of(kick.speed), farthest) / static_cast<double>(kicks.size());
    angles.push_back(wrapped(kick.direction - model.direction));
  }
  numbers.range = distance_of(likeliest_speed(kicks, model, sight));
  const double middle = lab::median_of(angles);
  for (double& angle : angles) angle = std::abs(angle - middle);
  numbers.direction = model.direction + middle;
  numbers.deviation = kOfMedian * lab::median_of(std::move(angles));
  return numbers;
}

void add_kind(const KickFit& seen, const sim::motion::Kick& kick, const sim::Models& models,
              std::vector<Statistic>& all) {
  const double deceleration = models.ball.deceleration;
  const KickModel model = kick_model_of(kick, models);
  const KickSight sight{.spread = models.motion.hits.spread, .slowest = seen.slowest};
  const KickNumbers recorded = numbers_of(seen.kicks, model, sight, deceleration);
  const auto named = [&](const char* what, const char* unit, double value) {
    return Statistic{.name = "kick " + seen.kind + ": " + what,
                     .unit = unit,
                     .recorded = value,
                     .simulated = {},
                     .events = seen.kicks.size(),
                     .kind = "kicks"};
  };
  Statistic mean = named("mean distance", "m", recorded.mean);
  Statistic range = named("likeliest range of full hits", "m", recorded.range);
  Statistic direction = named("median direction", "rad", recorded.direction);
  Statistic deviation = named("deviation of directions", "rad", recorded.deviation);
  KickDraw draw(model, sight);
  std::vector<TrackedKick> drawn(seen.kicks.size());
  for (std::size_t i = 0; i < kCheckSamples; ++i) {
    for (std::size_t k = 0; k < drawn.size(); ++k) drawn[k] = draw.like(seen.kicks[k]);
    const KickNumbers numbers = numbers_of(drawn, model, sight, deceleration);
    mean.simulated.push_back(numbers.mean), range.simulated.push_back(numbers.range);
    direction.simulated.push_back(numbers.direction), deviation.simulated.push_back(numbers.deviation);
  }
  for (Statistic* one : {&mean, &range, &direction, &deviation}) all.push_back(std::move(*one));
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
