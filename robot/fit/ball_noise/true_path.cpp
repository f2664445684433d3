#include "robot/fit/ball_noise/true_path.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "robot/fit/math/angles.h"
#include "robot/fit/math/resampling.h"

namespace robot::fit {
namespace {

constexpr std::size_t kFewestForScatter = 50;
constexpr double kExactScatter = 5e-5;  // [m] numbers of a simulated game
constexpr double kUneven = 1.5;         // intervals that differ more are no successive places

/// The weights of places in the value, the rate and half the second derivative of the curve.
struct Weights {
  double value, rate, bend;
};

/// The inverse of the matrix of normal equations, 1, t and t² being the terms. Empty if it is singular.
using Inverse = std::array<std::array<double, 3>, 3>;

std::optional<Inverse> inverse_of(const std::array<double, 5>& s, bool bends) {
  Inverse inverse{};
  if (!bends) {
    const double determinant = s[0] * s[2] - s[1] * s[1];
    if (determinant <= 1e-9 * s[0] * s[2]) return std::nullopt;
    inverse[0] = {s[2] / determinant, -s[1] / determinant, 0};
    inverse[1] = {-s[1] / determinant, s[0] / determinant, 0};
    return inverse;
  }
  const double c00 = s[2] * s[4] - s[3] * s[3], c01 = s[2] * s[3] - s[1] * s[4], c02 = s[1] * s[3] - s[2] * s[2];
  const double determinant = s[0] * c00 + s[1] * c01 + s[2] * c02;
  if (determinant <= 1e-9 * s[0] * s[2] * s[4]) return std::nullopt;
  const double c11 = s[0] * s[4] - s[2] * s[2], c12 = s[1] * s[2] - s[0] * s[3], c22 = s[0] * s[2] - s[1] * s[1];
  inverse[0] = {c00 / determinant, c01 / determinant, c02 / determinant};
  inverse[1] = {c01 / determinant, c11 / determinant, c12 / determinant};
  inverse[2] = {c02 / determinant, c12 / determinant, c22 / determinant};
  return inverse;
}

/// Returns the standard deviation of single values, for absolute third differences.
double scatter_of(std::vector<double> differences) {
  if (differences.size() < kFewestForScatter) return 0;
  // the third difference of independent values has 1 + 9 + 9 + 1 times their variance
  return kOfMedian * lab::median_of(std::move(differences)) / std::sqrt(20.);
}

/// Reports whether four places follow each other in equal intervals.
bool are_even(const lab::Path& path, std::size_t first) {
  double least = INFINITY, most = 0;
  for (std::size_t i = first; i < first + 3; ++i) {
    least = std::min(least, path[i + 1].at - path[i].at);
    most = std::max(most, path[i + 1].at - path[i].at);
  }
  return most <= lab::SmoothCurve::kLongestGap && most <= kUneven * least;
}

double turned_between(const lab::PlaceAt& one, const lab::PlaceAt& other) {
  return wrapped(other.heading - one.heading);
}

double typical_interval(const lab::Path& path) {
  std::vector<double> intervals;
  for (std::size_t i = 1; i < path.size(); ++i) intervals.push_back(path[i].at - path[i - 1].at);
  return lab::median_of(std::move(intervals));
}

}  // namespace

TruePath::TruePath(const lab::Path& path, const CurveShape& shape) : path_(path), shape_(shape) {
  // a line needs three places wherever the moment is between two, a parabola five
  shape_.half_window = std::max(shape_.half_window, (shape_.bends ? 2.6 : 1.6) * typical_interval(path));
}

std::optional<TruePath::Moment> TruePath::at(double seconds) const {
  const double from = seconds - shape_.half_window, to = seconds + shape_.half_window;
  const auto first = std::ranges::lower_bound(path_, from, {}, &lab::PlaceAt::at);
  auto last = first;
  std::array<double, 5> sums{};
  for (; last != path_.end() && last->at <= to; ++last) {
    if (last != first && last->at - (last - 1)->at > lab::SmoothCurve::kLongestGap) return std::nullopt;
    double power = 1;
    for (double& sum : sums) sum += power, power *= last->at - seconds;
  }
  const auto count = static_cast<std::size_t>(last - first), fewest = std::size_t{shape_.bends ? 5u : 3u};
  if (count < fewest || first->at > seconds - shape_.half_window / 3 ||
      (last - 1)->at < seconds + shape_.half_window / 3)
    return std::nullopt;
  const auto inverse = inverse_of(sums, shape_.bends);
  if (!inverse) return std::nullopt;

  const Inverse& m = *inverse;
  const auto weights_at = [&](double t) {
    return Weights{.value = m[0][0] + m[0][1] * t + m[0][2] * t * t,
                   .rate = m[1][0] + m[1][1] * t + m[1][2] * t * t,
                   .bend = m[2][0] + m[2][1] * t + m[2][2] * t * t};
  };
  // headings are counted from that of the first place, so that they do not jump
  Moment moment{.share = m[0][0], .rate_deviation = std::sqrt(m[1][1])};
  double turned = 0, bend_x = 0, bend_y = 0;
  for (auto place = first; place != last; ++place) {
    const Weights weights = weights_at(place->at - seconds);
    const double turn = turned_between(*first, *place);
    moment.x += weights.value * place->x, moment.y += weights.value * place->y;
    moment.speed_x += weights.rate * place->x, moment.speed_y += weights.rate * place->y;
    bend_x += weights.bend * place->x, bend_y += weights.bend * place->y;
    turned += weights.value * turn, moment.turn_rate += weights.rate * turn;
  }
  moment.heading = wrapped(first->heading + turned);
  moment.bend = 2 * std::hypot(bend_x, bend_y);
  double squares = 0;
  for (auto place = first; place != last; ++place) {
    const double t = place->at - seconds;
    squares += std::pow(place->x - moment.x - moment.speed_x * t - bend_x * t * t, 2) +
               std::pow(place->y - moment.y - moment.speed_y * t - bend_y * t * t, 2);
  }
  const std::size_t terms = shape_.bends ? 3 : 2;
  moment.scatter = count > terms ? std::sqrt(squares / (2 * static_cast<double>(count - terms))) : 0;
  return moment;
}

double scatter_of_places(const lab::Path& path) {
  std::vector<double> differences;
  for (std::size_t i = 0; i + 3 < path.size(); ++i) {
    if (!are_even(path, i)) continue;
    differences.push_back(std::abs(path[i + 3].x - 3 * path[i + 2].x + 3 * path[i + 1].x - path[i].x));
    differences.push_back(std::abs(path[i + 3].y - 3 * path[i + 2].y + 3 * path[i + 1].y - path[i].y));
  }
  return scatter_of(std::move(differences));
}

double scatter_of_headings(const lab::Path& path, const std::vector<bool>& counts) {
  std::vector<double> differences;
  for (std::size_t i = 0; i + 3 < path.size(); ++i) {
    if (!counts[i] || !counts[i + 3] || !are_even(path, i)) continue;
    const double before = turned_between(path[i], path[i + 1]), middle = turned_between(path[i + 1], path[i + 2]);
    const double after = turned_between(path[i + 2], path[i + 3]);
    if (std::isfinite(before + middle + after)) differences.push_back(std::abs(after - 2 * middle + before));
  }
  return scatter_of(std::move(differences));
}

TruthError truth_error(double deviation, double scatter, double scatter_of_ball) {
  if (scatter_of_ball < kExactScatter) return {.scatter = scatter, .shared = 0};
  return {.scatter = scatter, .shared = std::sqrt(std::max(0., deviation * deviation - scatter * scatter))};
}

}  // namespace robot::fit
