#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <random>

#include "robot/core/text.h"
#include "robot/fit/checking/checks.h"
#include "robot/fit/visibility/detection.h"

namespace robot::fit {
namespace {

constexpr std::size_t kFewestPasses = 10;
constexpr double kLeastExposure = 60;  // [s] of images that would show a false ball
constexpr double kSightError = 0.005;  // of a share: the truth's errors put balls in or out of view

/// The distances that are compared [m].
struct Distances {
  double from, to;
};
constexpr std::array<Distances, 4> kDistances{{{0, 1}, {1, 2}, {2, 4}, {4, 8}}};

/// The images of some distances.
struct SightCount {
  double images = 0, seen = 0, expected = 0;
  double variance = 0;   // of `expected`, each image by itself
  double by_passes = 0;  // the same by the luck of whole passes
  std::size_t passes = 0;
};

SightCount count_sights(const Sights& sights, const std::vector<Group>& passes, const Distances& distances,
                        const sim::Models& models) {
  const DetectionCurve curve = curve_of(models.perception.ball);
  SightCount count;
  for (const Group& pass : passes) {
    double missed = 0, images = 0;
    for (const std::size_t i : pass) {
      const Sight& sight = sights.sights[i];
      if (sight.distance < distances.from || sight.distance >= distances.to) continue;
      Sight shown = sight;
      if (!models.effects.occlusion) shown.hidden = false;
      const double chance = models.effects.missed_ball ? shown_by(curve, shown) : shown.hidden ? 0 : shown.plausible;
      images += 1, count.expected += chance, count.variance += chance * (1 - chance);
      count.seen += sight.seen ? 1 : 0;
      missed += (sight.seen ? 1 : 0) - chance;
    }
    if (images == 0) continue;
    count.images += images, ++count.passes;
    count.by_passes += missed * missed;
  }
  // a wrong model misses all passes to one side: that is no luck
  const double mean = (count.seen - count.expected) / std::max<double>(1, static_cast<double>(count.passes));
  count.by_passes -= mean * mean * static_cast<double>(count.passes);
  return count;
}

Statistic share_seen(const SightCount& count, const Distances& distances, std::uint64_t seed) {
  Statistic statistic{.name = formatted("vision: share of balls seen at %.0f-%.0f m", distances.from, distances.to),
                      .unit = "",
                      .recorded = count.seen / count.images,
                      .simulated = {},
                      .events = count.passes,
                      .kind = "passes"};
  const double deviation = std::sqrt(std::max(count.variance, count.by_passes)) / count.images;
  std::mt19937_64 random(seed);
  std::normal_distribution<double> drawn(count.expected / count.images, std::hypot(deviation, kSightError));
  for (std::size_t i = 0; i < kCheckSamples; ++i) statistic.simulated.push_back(std::clamp(drawn(random), 0., 1.));
  return statistic;
}

}  // namespace

std::vector<Statistic> check_sights(const Sights& sights, const sim::Models& models,
                                    std::vector<std::string>& missing) {
  std::vector<Statistic> all;
  const std::vector<Group> passes = passes_of(sights.sights);
  for (std::size_t i = 0; i < kDistances.size(); ++i) {
    const SightCount count = count_sights(sights, passes, kDistances[i], models);
    if (count.passes >= kFewestPasses)
      all.push_back(share_seen(count, kDistances[i], 20 + i));
    else
      missing.push_back(formatted("vision: expected at least %zu passes of a ball in view at %.0f-%.0f m, got %zu",
                                  kFewestPasses, kDistances[i].from, kDistances[i].to, count.passes));
  }
  return all;
}

std::vector<Statistic> check_false_balls(const Looks& looks, const sim::Models& models,
                                         std::vector<std::string>& missing) {
  const FalseBalls seen = false_balls_in(looks, models);
  if (!(seen.exposure >= kLeastExposure)) {
    missing.push_back(formatted("vision: expected at least %.0f s of images that would show a false ball, got %.0f",
                                kLeastExposure, seen.exposure));
    return {};
  }
  const double rate = models.effects.false_balls ? models.perception.filter.false_per_second : 0;
  const auto balls = static_cast<std::size_t>(std::ranges::count(seen.balls, true, &FalseBall::first));
  Statistic statistic{.name = "vision: number of false balls",
                      .unit = "",
                      .recorded = static_cast<double>(balls),
                      .simulated = {},
                      .events = balls,
                      .kind = "false balls"};
  std::mt19937_64 random(9);
  std::poisson_distribution<int> drawn(std::max(1e-9, rate * seen.exposure));
  for (std::size_t i = 0; i < kCheckSamples; ++i) statistic.simulated.push_back(drawn(random));
  return {statistic};
}

}  // namespace robot::fit
