#include "sim/foresight/forecast.h"

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "sim/foresight/race.h"
#include "sim/math/random.h"

namespace sim::foresight {
namespace {

constexpr int kDraws = 1000;  // for P(best): 0.016 of standard error at most

constexpr double kAlike = 0.005;      // [unit] smaller gains are written as 0.00
constexpr double kAside = 0.5 * 0.5;  // [unit²] of the additional rollout that errors assume

/// Returns the quantile of the normal distribution, within 0.00045 (Abramowitz and Stegun, 26.2.23).
double normal_quantile(double sure) {
  const auto t = static_cast<double>(std::sqrt(-2 * log(static_cast<float>(1 - sure))));
  return t - (2.515517 + t * (0.802853 + t * 0.010328)) / (1 + t * (1.432788 + t * (0.189269 + t * 0.001308)));
}

/// Returns the number of stripes that both played. A strategy that leaves the race does not come back.
int common(const RolloutStatistics& statistics, int i, int j) {
  return std::min(statistics.by_strategy[i].rollouts, statistics.by_strategy[j].rollouts);
}

/// Returns the covariance between the gains of two strategies in the same stripe.
double covariance(const RolloutStatistics& statistics, int i, int j) {
  const int count = common(statistics, i, j);
  if (count < 2) return 0;
  return (statistics.products[i][j] - statistics.gains[i][j] * statistics.gains[j][i] / count) / (count - 1);
}

double mean_gain(const RolloutStatistics& statistics, int i) {
  return statistics.by_strategy[i].rollouts == 0 ? 0 : statistics.gains[i][i] / statistics.by_strategy[i].rollouts;
}

/// Returns the standard error of a mean of `count` values with this variance.
double error_of(double variance, int count) {
  return count < 2 ? 0 : std::sqrt((std::max(variance, 0.) + kAside / count) / count);
}

double gain_error(const RolloutStatistics& statistics, int i) {
  return error_of(covariance(statistics, i, i), statistics.by_strategy[i].rollouts);
}

/// The lower triangle whose product with its transpose is the covariance of the mean gains.
struct Triangle {
  double at[kMaxStrategies][kMaxStrategies] = {};

  explicit Triangle(const RolloutStatistics& statistics) {
    for (int i = 1; i < statistics.strategies; ++i)
      for (int j = 1; j <= i; ++j) {
        const int count = std::max({statistics.by_strategy[i].rollouts, statistics.by_strategy[j].rollouts, 1});
        double rest =
            i == j ? gain_error(statistics, i) * gain_error(statistics, i) : covariance(statistics, i, j) / count;
        for (int k = 1; k < j; ++k) rest -= at[i][k] * at[j][k];
        if (i == j)
          at[i][i] = std::sqrt(std::max(rest, 0.));
        else
          at[i][j] = at[j][j] > 0 ? rest / at[j][j] : 0;
      }
  }
};

/// Sets the probability that each strategy is best: draws mean gains from their normal distribution.
void count_best(const RolloutStatistics& statistics, RandomKey key, Standing* standings) {
  const Triangle triangle(statistics);
  for (int n = 0; n < kDraws; ++n) {
    float drawn[kMaxStrategies];
    for (std::uint32_t pair = 0; pair < kMaxStrategies / 2; ++pair) {
      const auto words = draw(key, pair, Draw::belief, static_cast<std::uint32_t>(n) + 1);
      const auto two = normals(words[0], words[1]);
      drawn[2 * pair] = two[0];
      drawn[2 * pair + 1] = two[1];
    }
    int best = 0;
    double most = 0;  // the incumbent's
    for (int i = 1; i < statistics.strategies; ++i) {
      double gain = mean_gain(statistics, i);
      for (int j = 1; j <= i; ++j) gain += triangle.at[i][j] * static_cast<double>(drawn[j]);
      if (gain > most) most = gain, best = i;
    }
    standings[best].best += 1. / kDraws;
  }
}

Standing standing_of(const RolloutStatistics& statistics, int i) {
  const StrategyStatistics& strategy = statistics.by_strategy[i];
  const int n = strategy.rollouts;
  Standing standing{.rollouts = n, .raced_on = strategy.racing};
  if (n == 0) return standing;
  standing.mean = strategy.sum / n;
  standing.score = static_cast<double>(strategy.scored) / n;
  standing.concede = static_cast<double>(strategy.conceded) / n;
  if (n < 2) return standing;
  standing.error = error_of((strategy.squares - strategy.sum * strategy.sum / n) / (n - 1), n);
  if (i == 0) return standing;
  const double reach = student(0.975, n - 1) * gain_error(statistics, i);
  standing.gain = mean_gain(statistics, i);
  standing.gain_low = standing.gain - reach;
  standing.gain_high = standing.gain + reach;
  return standing;
}

const char* unit_of(Measure measure) { return measure == Measure::goal_difference ? "goals" : "in probability"; }

std::string text(const char* format, auto... values) {
  char buffer[320];
  std::snprintf(buffer, sizeof buffer, format, values...);
  return buffer;
}

}  // namespace

double student(double sure, double freedom) {
  // Cornish and Fisher's expansion round the normal distribution's
  const double z = normal_quantile(sure);
  const double z3 = z * z * z, z5 = z3 * z * z, z7 = z5 * z * z;
  return z + (z3 + z) / (4 * freedom) + (5 * z5 + 16 * z3 + 3 * z) / (96 * freedom * freedom) +
         (3 * z7 + 19 * z5 + 17 * z3 - 15 * z) / (384 * freedom * freedom * freedom);
}

Forecast forecast(const RolloutStatistics& statistics, const Question& question, RandomKey key) {
  Forecast forecast{.strategies = statistics.strategies};
  for (int i = 0; i < statistics.strategies; ++i) forecast.standings[i] = standing_of(statistics, i);
  if (statistics.stripes > 0) count_best(statistics, key, forecast.standings);
  for (int i = 1; i < statistics.strategies; ++i) {
    const Standing& standing = forecast.standings[i];
    if (!standing.raced_on) continue;
    const int so_far = forecast.challenger;
    if (so_far == 0 || standing.gain > forecast.standings[so_far].gain) forecast.challenger = i;
  }
  if (statistics.stripes < kFewestStripes) return forecast;

  forecast.advice = Forecast::Advice::keep;
  const int challenger = forecast.challenger;
  if (challenger == 0) return forecast;
  const double reach = student(static_cast<double>(question.sure), statistics.by_strategy[challenger].rollouts - 1);
  const double least = forecast.standings[challenger].gain - reach * gain_error(statistics, challenger);
  if (least <= static_cast<double>(question.switching_cost)) return forecast;
  forecast.advice = Forecast::Advice::change;
  forecast.choice = challenger;
  return forecast;
}

std::string reason(const Forecast& forecast, const Question& question, const std::string* names) {
  const Standing& incumbent = forecast.standings[0];
  if (forecast.advice == Forecast::Advice::none)
    return text("no advice: %d of at least %d futures were played in the time given", incumbent.rollouts,
                kFewestStripes);
  const std::string& kept = names[0];
  if (forecast.challenger == 0) return text("keeps %s: there is nothing else to play", kept.c_str());
  const Standing& best = forecast.standings[forecast.challenger];
  const std::string& name = names[forecast.challenger];
  const char* unit = unit_of(question.measure);
  const double reach = best.gain_high - best.gain;
  if (forecast.advice == Forecast::Advice::change)
    return text("changes from %s to %s: that gains %.2f ± %.2f %s (%d futures)", kept.c_str(), name.c_str(), best.gain,
                reach, unit, best.rollouts);
  if (best.gain_high < 0)
    return text("keeps %s: %s, the best of the others, would lose %.2f ± %.2f %s (%d futures)", kept.c_str(),
                name.c_str(), -best.gain, reach, unit, best.rollouts);
  if (best.gain_low > 0)
    return text("keeps %s: %s would gain %.2f ± %.2f %s, too little for a change, which costs %.2f (%d futures)",
                kept.c_str(), name.c_str(), best.gain, reach, unit, static_cast<double>(question.switching_cost),
                best.rollouts);
  if (std::abs(best.gain) < kAlike && reach < kAlike)
    return text("keeps %s: no difference from %s was seen in %d futures", kept.c_str(), name.c_str(), best.rollouts);
  if (std::abs(best.gain) < kAlike)
    return text("keeps %s: %s comes to the same, within %.2f %s (%d futures)", kept.c_str(), name.c_str(), reach, unit,
                best.rollouts);
  if (best.gain <= 0)
    return text("keeps %s: nothing else looks better; %s comes next, with %.2f ± %.2f %s less (%d futures)",
                kept.c_str(), name.c_str(), std::abs(best.gain), reach, unit, best.rollouts);
  return text("keeps %s: %s would gain %.2f ± %.2f %s, which may be chance (%d futures)", kept.c_str(), name.c_str(),
              best.gain, reach, unit, best.rollouts);
}

}  // namespace sim::foresight
