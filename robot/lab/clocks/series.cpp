#include "robot/lab/clocks/series.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

namespace robot::lab {
namespace {

constexpr double kGrid = 0.01;        // [s] between the values of a curve
constexpr double kHalfWindow = 0.13;  // [s] of a parabola, four samples of 30 Hz on each side
constexpr std::size_t kLeastSamples = 4;

using Iterator = Series::const_iterator;

double median_interval(const Series& series) {
  std::vector<double> intervals;
  for (std::size_t i = 1; i < series.size(); ++i) intervals.push_back(series[i].at - series[i - 1].at);
  return median_of(std::move(intervals));
}

/// Returns the value at `at` of the parabola through the samples, which are weighted by a triangle. Returns NaN if they do
/// not determine one.
double parabola_at(double at, double half_window, Iterator begin, Iterator end) {
  std::array<double, 5> powers{};  // sums of weight * u^k
  std::array<double, 3> values{};
  for (auto sample = begin; sample != end; ++sample) {
    const double u = (sample->at - at) / half_window, weight = std::max(0.0, 1 - std::abs(u));
    double power = weight;
    for (std::size_t k = 0; k < powers.size(); ++k, power *= u) {
      powers[k] += power;
      if (k < values.size()) values[k] += power * sample->value;
    }
  }
  // Cramer's rule for the constant term
  const auto& [s0, s1, s2, s3, s4] = powers;
  const double c0 = s2 * s4 - s3 * s3, c1 = s2 * s3 - s1 * s4, c2 = s1 * s3 - s2 * s2;
  const double determinant = s0 * c0 + s1 * c1 + s2 * c2;
  if (determinant < 1e-6 * s0 * s0 * s0) return std::nan("");
  return (values[0] * c0 + values[1] * c1 + values[2] * c2) / determinant;
}

}  // namespace

double median_of(std::vector<double> values) {
  if (values.empty()) return 0;
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::ranges::nth_element(values, middle);
  return *middle;
}

Series tidied(Series series) {
  std::erase_if(series, [](const Sample& sample) { return !std::isfinite(sample.at) || !std::isfinite(sample.value); });
  std::ranges::stable_sort(series, {}, &Sample::at);
  const auto is_same = [](const Sample& a, const Sample& b) { return a.at == b.at; };
  series.erase(std::unique(series.begin(), series.end(), is_same), series.end());
  return series;
}

SmoothCurve::SmoothCurve(const Series& series) {
  const double half_window = std::max(kHalfWindow, 2.2 * median_interval(series));
  for (auto begin = series.begin(); begin != series.end();) {
    auto end = begin + 1;
    while (end != series.end() && end->at - (end - 1)->at <= kLongestGap) ++end;
    Piece piece{.start = begin->at, .values = {}};
    auto from = begin, to = begin;
    const auto steps = static_cast<std::size_t>(((end - 1)->at - begin->at) / kGrid);
    for (std::size_t step = 0; step <= steps && static_cast<std::size_t>(end - begin) >= kLeastSamples; ++step) {
      const double at = piece.start + static_cast<double>(step) * kGrid;
      while (from->at < at - half_window) ++from;
      while (to != end && to->at <= at + half_window) ++to;
      piece.values.push_back(parabola_at(at, half_window, from, to));
    }
    if (!piece.values.empty()) pieces_.push_back(std::move(piece));
    begin = end;
  }
}

std::optional<double> SmoothCurve::at(double seconds) const {
  const auto next = std::ranges::upper_bound(pieces_, seconds, {}, &Piece::start);
  if (next == pieces_.begin()) return std::nullopt;
  const Piece& piece = *(next - 1);
  const double place = (seconds - piece.start) / kGrid;
  if (!(place < static_cast<double>(piece.values.size() - 1))) return std::nullopt;
  const auto before = static_cast<std::size_t>(place);
  const double part = place - static_cast<double>(before);
  const double value = piece.values[before] * (1 - part) + piece.values[before + 1] * part;
  if (std::isnan(value)) return std::nullopt;
  return value;
}

std::optional<double> SmoothCurve::rate_at(double seconds) const {
  constexpr double kReach = 0.05;  // [s]
  const auto before = at(seconds - kReach), after = at(seconds + kReach);
  if (!before || !after) return std::nullopt;
  return (*after - *before) / (2 * kReach);
}

}  // namespace robot::lab
