#include "robot/fit/ball_distance/curve.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "robot/lab/clocks/series.h"

namespace robot::fit {
namespace {

constexpr double kMostCorrection = 0.1;  // of the distance: where it is more, the series is none
constexpr int kRounds = 4;               // of fits with new deviations of the radius
// bounds of the pinhole: a camera of any width of view and a ball of any year; half a pixel of blur on each side, and more
constexpr double kLeastScale = 1, kMostScale = 200;       // [m px]
constexpr double kLeastOffset = -5, kMostOffset = 5;      // [px]
constexpr double kLeastHeight = 0.05, kMostHeight = 1.5;  // [m]

/// The radius of a ball by the parameters of the pinhole.
double radius_at(const Vector& p, double distance) { return p[1] + p[0] / std::hypot(distance, p[2]); }

/// Its change per metre of distance [px/m].
double slope_at(const Vector& p, double distance) {
  const double slant = std::hypot(distance, p[2]);
  return p[0] * distance / (slant * slant * slant);
}

Vector pinhole(const std::vector<BallSize>& sizes, const std::vector<std::size_t>& chosen, const RadiusNoise& noise,
               const Vector& start) {
  std::vector<double> of_radius;
  of_radius.reserve(chosen.size());
  for (const std::size_t i : chosen) of_radius.push_back(noise.of(radius_at(start, sizes[i].distance)));
  // the part of the true distance moves with the parameters: so the true distances themselves are fitted, too (Deming)
  const auto residuals = [&](const Vector& p, Vector& errors) {
    errors.resize(chosen.size());
    for (std::size_t k = 0; k < chosen.size(); ++k) {
      const BallSize& size = sizes[chosen[k]];
      const double of_truth = slope_at(p, size.distance) * size.deviation;
      errors[k] = (size.radius - radius_at(p, size.distance)) / std::hypot(of_radius[k], of_truth);
    }
  };
  return minimise({.least = {kLeastScale, kLeastOffset, kLeastHeight},
                   .most = {kMostScale, kMostOffset, kMostHeight},
                   .residuals = residuals,
                   .loss = Loss::cauchy},
                  start)
      .parameters;
}

/// Returns the deviation of radii around the curve: a line through the medians of the smaller and the larger ones.
RadiusNoise noise_around(const Vector& p, const std::vector<BallSize>& sizes, const std::vector<std::size_t>& chosen) {
  std::vector<std::size_t> ordered = chosen;
  std::ranges::sort(ordered, {}, [&](std::size_t i) { return sizes[i].distance; });
  const auto half = [&](std::size_t from, std::size_t to) {
    std::vector<double> errors, radii;
    for (std::size_t k = from; k < to; ++k) {
      const BallSize& size = sizes[ordered[k]];
      const double by_truth = slope_at(p, size.distance) * size.deviation;
      const double error = size.radius - radius_at(p, size.distance);
      errors.push_back(std::sqrt(std::max(0., error * error - by_truth * by_truth)));
      radii.push_back(radius_at(p, size.distance));
    }
    return std::pair(lab::median_of(std::move(radii)), kOfMedian * lab::median_of(std::move(errors)));
  };
  const std::size_t middle = ordered.size() / 2;
  const auto [large, of_large] = half(0, middle);
  const auto [small, of_small] = half(middle, ordered.size());
  if (large - small < 1) return {.base = (of_large + of_small) / 2, .share = 0};
  const double share = std::max(0., (of_large - of_small) / (large - small));
  return {.base = std::max(0., of_small - share * small), .share = share};
}

Curve fit_pinhole(const std::vector<BallSize>& sizes, const std::vector<std::size_t>& chosen) {
  std::vector<double> scales;
  for (const std::size_t i : chosen) scales.push_back(sizes[i].radius * std::hypot(sizes[i].distance, 0.4));
  Vector p{std::clamp(lab::median_of(std::move(scales)), kLeastScale, kMostScale), 0, 0.4};
  RadiusNoise noise;
  for (int round = 0; round < kRounds; ++round) {
    p = pinhole(sizes, chosen, noise, p);
    if (chosen.size() >= 4) noise = noise_around(p, sizes, chosen);
  }
  return {.kind = CurveKind::pinhole, .parameters = std::move(p), .noise = noise};
}

Vector fit_power_law(const std::vector<BallSize>& sizes, const std::vector<std::size_t>& chosen) {
  double n = 0, x = 0, y = 0, xx = 0, xy = 0;
  for (const std::size_t i : chosen) {
    if (sizes[i].distance <= 0) continue;
    const double lr = std::log(sizes[i].radius), ld = std::log(sizes[i].distance);
    n += 1, x += lr, y += ld, xx += lr * lr, xy += lr * ld;
  }
  const double spread = n * xx - x * x;
  const double power = spread > 1e-12 ? (n * xy - x * y) / spread : 0;
  return {std::exp((y - power * x) / std::max(1., n)), power};
}

Vector fit_constant(const std::vector<BallSize>& sizes, const std::vector<std::size_t>& chosen) {
  std::vector<double> distances;
  for (const std::size_t i : chosen) distances.push_back(sizes[i].distance);
  return {lab::median_of(std::move(distances))};
}

}  // namespace

double RadiusNoise::of(double radius) const { return std::max(0.1, base + share * radius); }

std::string_view name_of(CurveKind kind) {
  switch (kind) {
    case CurveKind::constant: return "constant";
    case CurveKind::power_law: return "power law";
    case CurveKind::pinhole: break;
  }
  return "pinhole";
}

double Curve::distance(double radius) const {
  switch (kind) {
    case CurveKind::constant: return parameters[0];
    case CurveKind::power_law: return parameters[0] * std::pow(radius, parameters[1]);
    case CurveKind::pinhole: break;
  }
  const double from_blur = std::max(0.3, radius - parameters[1]), slant = parameters[0] / from_blur;
  const double square = slant * slant - parameters[2] * parameters[2];
  if (square <= 0) return 0;
  const double straight = std::sqrt(square), share = slant / straight;
  // half the second derivative of the distance, by the variance of the radius
  const double bend = straight * share * share * (3 - share * share) / (from_blur * from_blur);
  const double sigma = noise.of(radius), most = kMostCorrection * straight;
  return straight - std::clamp(bend * sigma * sigma / 2, -most, most);
}

Curve fit_curve(CurveKind kind, const std::vector<BallSize>& sizes, const std::vector<std::size_t>& chosen) {
  switch (kind) {
    case CurveKind::constant: return {.kind = kind, .parameters = fit_constant(sizes, chosen)};
    case CurveKind::power_law: return {.kind = kind, .parameters = fit_power_law(sizes, chosen)};
    case CurveKind::pinhole: break;
  }
  return fit_pinhole(sizes, chosen);
}

}  // namespace robot::fit
