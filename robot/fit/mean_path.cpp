#include "robot/fit/mean_path.h"

#include <algorithm>

namespace robot::fit {
namespace {

constexpr double kFarthest = 100;  // [m] no field is that large
constexpr std::size_t kFewestOfSlope = 4;

bool is_possible(const lab::PlaceAt& place) {
  return std::isfinite(place.at) && std::abs(place.x) < kFarthest && std::abs(place.y) < kFarthest;
}

}  // namespace

MeanPath::MeanPath(const lab::Path& path) : sums_(1) {
  for (const lab::PlaceAt& place : path) {
    if (!is_possible(place)) {
      ++left_out_;
      continue;
    }
    Sums sums = sums_.back();
    sums.at += place.at, sums.x += place.x, sums.y += place.y;
    if (std::isfinite(place.heading)) sums.cos += std::cos(place.heading), sums.sin += std::sin(place.heading);
    places_.push_back(place);
    sums_.push_back(sums);
  }
}

std::size_t MeanPath::first_from(double at) const {
  return static_cast<std::size_t>(std::ranges::lower_bound(places_, at, {}, &lab::PlaceAt::at) - places_.begin());
}

std::optional<MeanPath::Mean> MeanPath::over(double from, double to) const {
  constexpr double kTolerance = 1e-6;  // [s] times are sums of 1/30 s
  const std::size_t first = first_from(from - kTolerance), end = first_from(to + kTolerance);
  if (end <= first) return std::nullopt;
  const Sums &before = sums_[first], &after = sums_[end];
  const auto count = static_cast<double>(end - first);
  const double c = after.cos - before.cos, s = after.sin - before.sin;
  return Mean{.at = (after.at - before.at) / count,
              .x = (after.x - before.x) / count,
              .y = (after.y - before.y) / count,
              .heading = std::hypot(c, s) > 0.5 * count ? std::atan2(s, c) : NAN,
              .places = end - first};
}

std::optional<MeanPath::Slope> MeanPath::slope_over(double from, double to) const {
  const auto mean = over(from, to);
  if (!mean || mean->places < kFewestOfSlope) return std::nullopt;
  double tt = 0, tx = 0, ty = 0;
  for (std::size_t i = first_from(from); i < places_.size() && places_[i].at <= to; ++i) {
    const double t = places_[i].at - mean->at;
    tt += t * t, tx += t * (places_[i].x - mean->x), ty += t * (places_[i].y - mean->y);
  }
  if (!(tt > 0)) return std::nullopt;
  return Slope{.x = tx / tt, .y = ty / tt, .deviation = 1 / std::sqrt(tt)};
}

}  // namespace robot::fit
