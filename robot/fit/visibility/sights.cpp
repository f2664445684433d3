#include "robot/fit/visibility/sights.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "robot/fit/math/angles.h"
#include "robot/lab/clocks/series.h"

namespace robot::fit {
namespace {

constexpr double kHeadingError = 0.05;  // [rad] of a truth that too few percepts judge
constexpr std::size_t kFewestPercepts = 30;
constexpr double kNearBall = 3;                    // [m] farther away the horizon cuts errors of the elevation
constexpr double kFalse = 5, kFalseWay = 0.5;      // [standard deviations] and [m]: farther off is a false ball
constexpr double kBorderDoubt = 3;                 // [standard deviations]
constexpr double kBeyondRange = 2;                 // [ranges] the simulator drops a percept that seems farther away
constexpr double kPassPause = 0.5, kPassTime = 2;  // [s]

/// Returns one standard deviation of the elevation by the error of the truth's places.
double placed_elevation(const Look& look) {
  return look.placed * look.height / (look.distance * look.distance + look.height * look.height);
}

/// Returns the error of normal distribution whose absolute values these are, at least `least`.
double deviation_by(std::vector<double> errors, double least) {
  if (errors.size() < kFewestPercepts) return least;
  return std::max(least, kOfMedian * lab::median_of(std::move(errors)));
}

/// Returns the error without that of the truth's places.
double without(double error, double placed) { return std::sqrt(std::max(0., error * error - placed * placed)); }

double normal_below(double deviations) { return std::erfc(-deviations / std::numbers::sqrt2) / 2; }

/// Returns the probability that the simulator does not drop the percept of a ball (sim/perception/image.h, seen_through()).
double plausible(const Look& look, double noise, double far_range) {
  if (noise <= 0) return 1;
  const double h = look.height, d = look.distance, most = kBeyondRange * far_range;
  return normal_below(h * (most - d) / (most * d + h * h) / noise);
}

bool is_in_view(const Look& look, double bearing_noise, double ball_radius) {
  const double around = std::hypot(look.distance, look.height);
  const double ball = std::asin(std::min(1., ball_radius / around));
  const double beside = std::hypot(bearing_noise, look.placed / std::max(look.distance, 0.01));
  return look.across > ball + kBorderDoubt * beside && look.upright > ball + kBorderDoubt * placed_elevation(look);
}

}  // namespace

SightNoise noise_of(const Looks& looks, const sim::Models& base) {
  const sim::perception::Noise& model = base.perception.noise;
  const double pixels = model.pixels * base.perception.camera.pixel_angle;
  std::vector<std::vector<double>> bearings(looks.recordings.size());
  std::vector<double> elevations[2], placed[2];
  for (const Look& look : looks.looks) {
    if (!look.has_ball || std::min(look.across, look.upright) < 0 || look.hiding != Hiding::free) continue;
    if (look.distance > kNearBall || look.distance < look.height / 2) continue;
    const double seen = std::hypot(look.seen_x, look.seen_y);
    bearings[look.recording].push_back(std::abs(wrapped(std::atan2(look.seen_y, look.seen_x) - look.bearing)));
    elevations[look.walking].push_back(
        std::abs(std::atan2(look.height, seen) - std::atan2(look.height, look.distance)));
    placed[look.walking].push_back(placed_elevation(look));
  }
  SightNoise noise;
  for (std::vector<double>& errors : bearings) {
    const double assumed = errors.size() < kFewestPercepts ? kHeadingError : 0;
    noise.bearing.push_back(deviation_by(std::move(errors), std::hypot(pixels, model.roll, assumed)));
  }
  const double tilts[2] = {std::hypot(pixels, model.tilt), std::hypot(pixels, model.tilt_walking)};
  double* const found[2] = {&noise.standing, &noise.walking};
  for (std::size_t i = 0; i < 2; ++i) {
    *found[i] = tilts[i];
    if (elevations[i].size() < kFewestPercepts) continue;
    const double all = kOfMedian * lab::median_of(std::move(elevations[i]));
    *found[i] = without(all, lab::median_of(std::move(placed[i])));
  }
  return noise;
}

bool SightCounts::contain(double x, double y) const {
  const double range = std::hypot(x, y);
  return range >= nearest && range <= farthest && std::abs(wrapped(std::atan2(y, x) - bearing)) <= reach;
}

SightCounts ball_places(const Look& look, const SightNoise& noise) {
  const double tilt = std::hypot(look.walking ? noise.walking : noise.standing, placed_elevation(look));
  const double beside = std::hypot(noise.bearing[look.recording], look.placed / std::max(look.distance, 0.01));
  const double elevation = std::atan2(look.height, look.distance);
  const double low = elevation + kFalse * tilt, high = elevation - kFalse * tilt;
  SightCounts places{.bearing = look.bearing};
  places.nearest = std::max(0., std::min(look.distance - kFalseWay, low < M_PI_2 ? look.height / std::tan(low) : 0));
  places.farthest = std::max(look.distance + kFalseWay, high > 0 ? look.height / std::tan(high) : INFINITY);
  places.reach = std::min(M_PI, std::max(kFalse * beside, kFalseWay / std::max(look.distance, 0.01)));
  return places;
}

bool is_true_ball(const Look& look, const SightNoise& noise) {
  return look.has_ball && ball_places(look, noise).contain(look.seen_x, look.seen_y);
}

Sights sights_of(const Looks& looks, const sim::Models& base) {
  const SightNoise noise = noise_of(looks, base);
  Sights found{.recordings = looks.recordings};
  for (const Look& look : looks.looks) {
    if (std::min(look.across, look.upright) < 0) continue;
    if (!is_in_view(look, noise.bearing[look.recording], base.ball.radius)) {
      ++found.near_border;
    } else if (look.hiding == Hiding::unsure) {
      ++found.unsure;
    } else {
      const double error = base.effects.ball_noise ? (look.walking ? noise.walking : noise.standing) : 0;
      found.error = std::max(found.error, look.placed);
      found.sights.push_back({.recording = look.recording,
                              .at = look.at,
                              .distance = look.distance,
                              .off_axis = std::abs(wrapped(look.bearing - look.axis)),
                              .head_speed = look.head_speed,
                              .hidden = look.hiding == Hiding::hidden,
                              .seen = is_true_ball(look, noise),
                              .plausible = plausible(look, error, base.perception.ball.far_range)});
    }
  }
  return found;
}

std::vector<Group> passes_of(const std::vector<Sight>& sights) {
  std::vector<Group> passes;
  double begun = 0;
  for (std::size_t i = 0; i < sights.size(); ++i) {
    const Sight& sight = sights[i];
    const bool goes_on = i > 0 && sight.recording == sights[i - 1].recording &&
                         sight.at < sights[i - 1].at + kPassPause && sight.at < begun + kPassTime;
    if (!goes_on) {
      passes.emplace_back();
      begun = sight.at;
    }
    passes.back().push_back(i);
  }
  return passes;
}

}  // namespace robot::fit
