#include "sim/compare/verdict.h"

#include <cmath>
#include <limits>

namespace sim::compare {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();
constexpr std::int64_t kPatience = 1000;  // [pairs] after which a sequential test gives up on a rare gain
constexpr std::int64_t kRare = 20;        // a gain in fewer than one of this many pairs is rare
constexpr double kNormal975 = 1.959963984540054, kNormal95 = 1.644853626951473, kNormal80 = 0.841621233572914;

/// Returns the 97.5 % quantile of Student's t (Cornish and Fisher's expansion; error < 0.2 % from 5 degrees on).
double student_975(double degrees) {
  const double z = kNormal975, z2 = z * z;
  const double first = z * (z2 + 1) / 4;
  const double second = z * ((5 * z2 + 16) * z2 + 3) / 96;
  const double third = z * (((3 * z2 + 19) * z2 + 17) * z2 - 15) / 384;
  return z + (first + (second + third / degrees) / degrees) / degrees;
}

/// Returns the unbiased variance, or 0 for fewer than two values.
double variance_of(std::int64_t count, std::int64_t sum, std::int64_t squares) {
  if (count < 2) return 0;
  const auto n = static_cast<double>(count), total = static_cast<double>(sum);
  return (static_cast<double>(squares) - total * (total / n)) / (n - 1);
}

Interval interval_of(std::int64_t count, std::int64_t sum, std::int64_t squares, double scale) {
  if (count == 0) return {.mean = 0, .low = -kInfinity, .high = kInfinity};
  const auto n = static_cast<double>(count);
  const double mean = static_cast<double>(sum) / n * scale;
  if (count < 2) return {.mean = mean, .low = -kInfinity, .high = kInfinity};
  const double off = student_975(n - 1) * std::sqrt(variance_of(count, sum, squares) / n) * scale;
  return {.mean = mean, .low = mean - off, .high = mean + off};
}

}  // namespace

// a pair has two games
Interval gain_per_game(const PairStatistics& statistics, double unit) {
  return interval_of(statistics.pairs, statistics.gain, statistics.gain_squares, 0.5 / unit);
}

// half the difference between B's home game and its away game
Interval home_advantage(const PairStatistics& statistics, double unit) {
  const std::int64_t sum = statistics.game_gain[1] - statistics.game_gain[0];
  const std::int64_t squares = 2 * (statistics.game_gain_squares[0] + statistics.game_gain_squares[1]) -
                               statistics.gain_squares;  // (b-a)^2 = 2a^2+2b^2-(a+b)^2
  return interval_of(statistics.pairs, sum, squares, 0.5 / unit);
}

double pair_variance(const PairStatistics& statistics, double unit) {
  return variance_of(statistics.pairs, statistics.gain, statistics.gain_squares) / (4 * unit * unit);
}

double pairing_gain(const PairStatistics& statistics) {
  const double paired = pair_variance(statistics);
  if (paired <= 0) return 0;
  double of_a_game = 0;
  for (const int place : {0, 1})
    of_a_game += variance_of(statistics.pairs, statistics.game_gain[place], statistics.game_gain_squares[place]) / 2;
  return of_a_game / 2 / paired;  // two independent games have half the variance of one
}

Bounds bounds_of(const Hypothesis& hypothesis) {
  return {.h0 = std::log(hypothesis.beta / (1 - hypothesis.alpha)),
          .h1 = std::log((1 - hypothesis.beta) / hypothesis.alpha)};
}

Hypothesis asked(const Hypothesis& hypothesis, const PairStatistics& statistics, double unit) {
  Hypothesis made = hypothesis;
  if (hypothesis.part > 0) made.h1 = made.h0 + made.part * std::sqrt(pair_variance(statistics, unit));
  return made;
}

double llr(const PairStatistics& statistics, const Hypothesis& hypothesis, double unit) {
  const Hypothesis made = asked(hypothesis, statistics, unit);
  const double variance = pair_variance(statistics, unit);
  const double beyond_middle = gain_per_game(statistics, unit).mean - (made.h0 + made.h1) / 2;
  if (variance > 0) return static_cast<double>(statistics.pairs) * (made.h1 - made.h0) * beyond_middle / variance;
  return beyond_middle == 0 ? 0 : std::copysign(kInfinity, beyond_middle);
}

std::string_view name(Verdict verdict) {
  switch (verdict) {
    case Verdict::better: return "better";
    case Verdict::not_better: return "not better";
    case Verdict::undecided: return "undecided";
    case Verdict::identical: return "identical";
    case Verdict::too_rare: return "too rare";
  }
  return "";
}

Verdict decide(const PairStatistics& statistics, const Hypothesis& hypothesis, double unit) {
  if (statistics.pairs < hypothesis.fewest_pairs) return Verdict::undecided;
  if (statistics.same == statistics.pairs) return Verdict::identical;
  if (statistics.uneven < kFewestUneven) return statistics.pairs < kPatience ? Verdict::undecided : Verdict::too_rare;
  const double ratio = llr(statistics, hypothesis, unit);
  const Bounds bounds = bounds_of(hypothesis);
  if (ratio >= bounds.h1) return Verdict::better;
  return ratio <= bounds.h0 ? Verdict::not_better : Verdict::undecided;
}

Verdict judge(const PairStatistics& statistics, const Hypothesis& hypothesis, double unit) {
  if (statistics.pairs < 2) return Verdict::undecided;
  if (statistics.same == statistics.pairs) return Verdict::identical;
  if (statistics.uneven < kFewestUneven)
    return statistics.uneven * kRare < statistics.pairs ? Verdict::too_rare : Verdict::undecided;
  const Interval gain = gain_per_game(statistics, unit);
  if (gain.low > hypothesis.h0) return Verdict::better;
  return gain.high < asked(hypothesis, statistics, unit).h1 ? Verdict::not_better : Verdict::undecided;
}

namespace {

/// A Brownian motion of variance 1 per unit of time that starts between two bounds: 0 < `start` < `width`.
struct Walk {
  double start, width;

  /// Returns the probability that it has left at the upper bound by `time`, with `drift` per unit of time.
  double up_by(double drift, double time) const {
    const double way = width - start;
    if (way * way > kSoon * time) return up_soon(drift, way, time);
    const double pi = std::acos(-1.0);
    const double ever = std::abs(drift * width) < 1e-9
                            ? start / width
                            : std::expm1(-2 * drift * start) / std::expm1(-2 * drift * width);
    // the part that leaves there later: eigenfunctions of the strip
    double later = 0;
    for (int n = 1; n <= kTerms; ++n) {
      const double rate = drift * drift / 2 + n * n * pi * pi / (2 * width * width);
      const double term = n * std::sin(n * pi * start / width) * std::exp(drift * way - rate * time) / rate;
      later += n % 2 == 1 ? term : -term;
    }
    return ever - pi / (width * width) * later;
  }

  /// Returns the probability of an outcome that indicates a larger drift than leaving above (or below) at `time`:
  /// leaving above sooner; or leaving above at all, or below later.
  double more_than(bool above, double time, double drift) const {
    const double up = up_by(drift, above ? time : kInfinity);
    if (above) return up;
    const Walk mirrored{width - start, width};
    return 1 - mirrored.up_by(-drift, time);
  }

  /// Returns the same for a time so short that the other bound does not matter (inverse Gaussian).
  static double up_soon(double drift, double way, double time) {
    const double root = std::sqrt(time), z = (way + drift * time) / root, off = (way - drift * time) / root;
    const double reflected =  // exp(2 drift way) Phi(-z), by the asymptotic tail where it would overflow
        z > 5 ? std::exp(-off * off / 2) * (1 - 1 / (z * z)) / (z * std::sqrt(2 * std::acos(-1.0)))
              : std::exp(2 * drift * way) * 0.5 * std::erfc(z / std::sqrt(2.0));
    return 0.5 * std::erfc(off / std::sqrt(2.0)) + reflected;
  }

  static constexpr int kTerms = 400;
  static constexpr double kSoon = 24;
};

}  // namespace

// the motion is the log-likelihood ratio: per pair it drifts by (h1-h0)(2 gain-h0-h1)/(2 variance), and varies by
// (h1-h0)^2/variance
Interval unbiased_gain(const PairStatistics& statistics, const Hypothesis& question, double unit) {
  const Hypothesis hypothesis = asked(question, statistics, unit);
  const double variance = pair_variance(statistics, unit);
  const double step = hypothesis.h1 - hypothesis.h0;
  const double ratio = llr(statistics, hypothesis, unit);
  const Bounds bounds = bounds_of(hypothesis);
  const bool above = ratio > 0;
  // the ratio stops beyond the bound by the step of one look
  const double lower = above ? bounds.h0 : std::min(bounds.h0, ratio);
  const double upper = above ? std::max(bounds.h1, ratio) : bounds.h1;
  const double scale = step / std::sqrt(variance);  // [ratio per root of a pair]
  const Walk walk{-lower / scale, (upper - lower) / scale};
  const auto time = static_cast<double>(statistics.pairs);
  const auto drift_of = [&](double gain) { return (gain - (hypothesis.h0 + hypothesis.h1) / 2) / std::sqrt(variance); };

  // find the gain at which a more extreme outcome has this probability, which rises with the gain
  const double mean = gain_per_game(statistics, unit).mean, off = 12 * std::sqrt(variance / time);
  const auto gain_at = [&](double probability) {
    double low = mean - off, high = mean + off;
    for (int i = 0; i < 60; ++i) {
      const double middle = (low + high) / 2;
      (walk.more_than(above, time, drift_of(middle)) < probability ? low : high) = middle;
    }
    return (low + high) / 2;
  };
  return {.mean = gain_at(0.5), .low = gain_at(0.025), .high = gain_at(0.975)};
}

Plan plan(double variance, double delta) {
  const double per_square = variance / (delta * delta);
  const auto fixed = [&](double power) { return (kNormal975 + power) * (kNormal975 + power) * per_square; };
  // Wald's expectations for errors of 5 %: 2 (0.95 ln 19 - 0.05 ln 19) and, in the middle, (ln 19)^2
  const double bound = std::log(19.0);
  return {.fixed_80 = fixed(kNormal80),
          .fixed_95 = fixed(kNormal95),
          .sequential = 2 * 0.9 * bound * per_square,
          .sequential_worst = bound * bound * per_square};
}

}  // namespace sim::compare
