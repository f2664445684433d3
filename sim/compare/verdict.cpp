#include "sim/compare/verdict.h"

#include <cmath>
#include <limits>

namespace sim::compare {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();
constexpr double kNormal975 = 1.959963984540054, kNormal95 = 1.644853626951473, kNormal80 = 0.841621233572914;

/// The 97.5 % quantile of Student's t (Cornish and Fisher's expansion; off by less than 0.2 % from 5 degrees on).
double student_975(double degrees) {
  const double z = kNormal975, z2 = z * z;
  const double first = z * (z2 + 1) / 4;
  const double second = z * ((5 * z2 + 16) * z2 + 3) / 96;
  const double third = z * (((3 * z2 + 19) * z2 + 17) * z2 - 15) / 384;
  return z + (first + (second + third / degrees) / degrees) / degrees;
}

/// Unbiased; 0 of fewer than two values.
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

// a pair's sum is of two games
Interval gain_per_game(const Tally& tally, double unit) {
  return interval_of(tally.pairs, tally.gain, tally.gain_squares, 0.5 / unit);
}

// at home B gains, away A does: half the difference of the two games of a pair
Interval home_advantage(const Tally& tally, double unit) {
  const std::int64_t sum = tally.game_gain[1] - tally.game_gain[0];
  const std::int64_t squares = 2 * (tally.game_gain_squares[0] + tally.game_gain_squares[1]) -
                               tally.gain_squares;  // (b-a)^2 = 2a^2+2b^2-(a+b)^2
  return interval_of(tally.pairs, sum, squares, 0.5 / unit);
}

double pair_variance(const Tally& tally, double unit) {
  return variance_of(tally.pairs, tally.gain, tally.gain_squares) / (4 * unit * unit);
}

double pairing_gain(const Tally& tally) {
  const double paired = pair_variance(tally);
  if (paired <= 0) return 0;
  double of_a_game = 0;
  for (const int place : {0, 1})
    of_a_game += variance_of(tally.pairs, tally.game_gain[place], tally.game_gain_squares[place]) / 2;
  return of_a_game / 2 / paired;  // two games without a bond have half the variance of one
}

Bounds bounds_of(const Question& question) {
  return {.h0 = std::log(question.beta / (1 - question.alpha)), .h1 = std::log((1 - question.beta) / question.alpha)};
}

double llr(const Tally& tally, const Question& question, double unit) {
  const double variance = pair_variance(tally, unit);
  const double mean = gain_per_game(tally, unit).mean;
  const double towards_h1 =
      static_cast<double>(tally.pairs) * (question.h1 - question.h0) * (2 * mean - question.h0 - question.h1) / 2;
  if (variance > 0) return towards_h1 / variance;
  return towards_h1 == 0 ? 0 : std::copysign(kInfinity, towards_h1);
}

std::string_view name(Verdict verdict) {
  switch (verdict) {
    case Verdict::better: return "better";
    case Verdict::not_better: return "not better";
    case Verdict::undecided: return "undecided";
    case Verdict::identical: return "identical";
  }
  return "";
}

Verdict decide(const Tally& tally, const Question& question, double unit) {
  if (tally.pairs < question.fewest_pairs) return Verdict::undecided;
  if (tally.gain_squares == 0) return Verdict::identical;
  const double ratio = llr(tally, question, unit);
  const Bounds bounds = bounds_of(question);
  if (ratio >= bounds.h1) return Verdict::better;
  return ratio <= bounds.h0 ? Verdict::not_better : Verdict::undecided;
}

Verdict judge(const Tally& tally, const Question& question, double unit) {
  if (tally.pairs < 2) return Verdict::undecided;
  if (tally.gain_squares == 0) return Verdict::identical;
  const Interval gain = gain_per_game(tally, unit);
  if (gain.low > question.h0) return Verdict::better;
  return gain.high < question.h1 ? Verdict::not_better : Verdict::undecided;
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
