#include "robot/fit/ball_noise/lag.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>

#include "robot/fit/ball_noise/profile.h"
#include "robot/fit/math/angles.h"

namespace robot::fit {
namespace {

constexpr double kLeastRollSpeed = 0.4;   // [m/s]
constexpr double kMostLyingSpeed = 0.1;   // [m/s]
constexpr double kNearestRoll = 0.5;      // [m] nearer, the truth's error turns the line of sight
constexpr double kOnLineOfSight = 0.8;    // cosine of the angle to it
constexpr double kMostFree = 0.8;         // [m/s²] deceleration of any turf
constexpr double kOfAcceleration = 15.5;  // [1/s] deviation of an acceleration in those of a speed (kBallCurve)
constexpr double kFirstLag = -0.15;       // [s]
constexpr double kLagStep = 0.005;        // [s]
constexpr std::size_t kLagSteps = 111;    // up to 0.4 s
constexpr double kCauchyWidth = 2.385;    // as Loss::cauchy
constexpr double kAboveHorizon = 3.5;     // standard deviations
constexpr std::size_t kFewestLying = 30, kFewestLagPasses = 8, kFewestPassesOfClock = 4;
constexpr std::size_t kMostLagImages = 20'000;

double lag_at(double step) { return kFirstLag + kLagStep * step; }

/// The errors of balls that lie, of one recording.
struct LyingErrors {
  double elevation = 0, bearing = 0;        // [rad] medians
  double of_elevation = 0, of_bearing = 0;  // [rad] robust standard deviations
};

double bearing_error(const BallPlace& place) { return wrapped(place.seen_bearing - place.bearing); }

double elevation_error(const BallPlace& place, double height) {
  return elevation_at(place.seen_distance, height) - elevation_at(place.distance, height);
}

/// Returns the median of some values, and the robust standard deviation around it.
std::array<double, 2> middle_and_deviation(std::vector<double> values) {
  const double middle = middle_of(values);
  for (double& value : values) value = std::abs(value - middle);
  return {middle, kOfMedian * middle_of(std::move(values))};
}

/// Returns the errors of each recording. One with too few balls that lie has no bias and the usual noise.
std::vector<LyingErrors> lying_errors(const std::vector<BallPlace>& places, std::size_t recordings,
                                      const ImageFacts& facts, const ImageNoise& usual) {
  std::vector<std::vector<double>> elevations(recordings), bearings(recordings);
  for (const BallPlace& place : places) {
    if (place.speed() > kMostLyingSpeed + 2 * place.speed_deviation || place.distance < kNearestRoll) continue;
    if (elevation_at(place.distance, facts.height) > 0.15)
      elevations[place.recording].push_back(elevation_error(place, facts.height));
    if (!std::isnan(place.bearing)) bearings[place.recording].push_back(bearing_error(place));
  }
  std::vector<LyingErrors> errors(recordings, {.of_elevation = std::hypot(usual.tilt_walking, facts.pixels),
                                               .of_bearing = std::hypot(usual.roll, facts.pixels)});
  constexpr double kLeast = 1e-4;  // [rad] the worth of a message's numbers
  for (std::size_t i = 0; i < recordings; ++i) {
    if (elevations[i].size() >= kFewestLying) {
      const auto [middle, deviation] = middle_and_deviation(std::move(elevations[i]));
      errors[i].elevation = middle, errors[i].of_elevation = std::max(kLeast, deviation);
    }
    if (bearings[i].size() >= kFewestLying) {
      const auto [middle, deviation] = middle_and_deviation(std::move(bearings[i]));
      errors[i].bearing = middle, errors[i].of_bearing = std::max(kLeast, deviation);
    }
  }
  return errors;
}

/// Returns the error of the seen place along the velocity of the ball [m], in the frame of the line of sight.
double error_along(const BallPlace& place, const LyingErrors& lying, double height) {
  const double seen = distance_at(elevation_at(place.seen_distance, height) - lying.elevation, height);
  if (std::isnan(place.bearing)) {  // then only a ball on the line of sight shows it
    const bool is_straight = std::abs(place.away) > kOnLineOfSight * place.speed() && std::isfinite(seen);
    return is_straight ? (seen - place.distance) * place.speed() / place.away : static_cast<double>(NAN);
  }
  const double turn = bearing_error(place) - lying.bearing;
  const double ahead = seen * std::cos(turn) - place.distance, aside = seen * std::sin(turn);
  const double along = (ahead * place.away + aside * place.across) / place.speed();
  return std::isfinite(along) ? along : static_cast<double>(NAN);
}

LagImage lag_image(const BallPlace& place, std::size_t index, const LyingErrors& lying, const ImageFacts& facts) {
  const double height = facts.height, elevation = elevation_at(place.distance, height);
  const double per_metre = height / (place.distance * place.distance + height * height);
  const double horizon = elevation_at(2 * facts.far_range, height) + kAboveHorizon * lying.of_elevation;
  return {.place = index,
          .recording = place.recording,
          .has_elevation = elevation > horizon,
          .elevation = elevation_error(place, height) - lying.elevation,
          .bearing = bearing_error(place) - lying.bearing,
          .of_elevation = std::hypot(lying.of_elevation, per_metre * place.deviation),
          .of_bearing = std::hypot(lying.of_bearing, place.deviation / place.distance, place.heading_deviation),
          .along = error_along(place, lying, height)};
}

void collect_rolls(const std::vector<BallPlace>& places, const std::vector<BallRecording>& recordings,
                   const std::vector<LyingErrors>& lying, const ImageFacts& facts, LagFit& fit) {
  for (std::size_t i = 0; i < places.size(); ++i) {
    const BallPlace& place = places[i];
    if (place.speed() < kLeastRollSpeed || place.distance < kNearestRoll) {
      ++fit.slow;
    } else if (place.acceleration > kMostFree + 3 * kOfAcceleration * place.speed_deviation) {
      ++fit.bent;
    } else if (recordings[place.recording].clock_by_ball) {
      ++fit.by_ball;
    } else {
      const LagImage image = lag_image(place, i, lying[place.recording], facts);
      if (image.has_elevation || !std::isnan(image.bearing)) fit.images.push_back(image);
    }
  }
}

double cauchy_cost(double deviations) {
  return kCauchyWidth * kCauchyWidth / 2 * std::log1p(deviations * deviations / (kCauchyWidth * kCauchyWidth));
}

/// Returns the cost of a lag for one image: the ball is compared with its place at that time before.
double cost_of(const LagImage& image, const BallPlace& place, const ImageFacts& facts, double lag) {
  // before, it was faster
  const double height = facts.height, seconds = lag * (1 + facts.deceleration * lag / (2 * place.speed()));
  const double ahead = place.distance - seconds * place.away, aside = -seconds * place.across;
  double cost = 0;
  if (!std::isnan(image.bearing)) cost += cauchy_cost((image.bearing - std::atan2(aside, ahead)) / image.of_bearing);
  if (image.has_elevation) {
    // the tangent of a difference of two angles
    const double then = std::sqrt(ahead * ahead + aside * aside), now = place.distance;
    const double moved = std::atan(height * (now - then) / (now * then + height * height));
    cost += cauchy_cost((image.elevation - moved) / image.of_elevation);
  }
  return cost;
}

/// Returns the profile of the lag: an event for each pass.
Profile lag_profile(const LagFit& fit, const std::vector<BallPlace>& places, const ImageFacts& facts) {
  const std::size_t stride = 1 + fit.images.size() / kMostLagImages;
  Profile profile(kLagSteps, lag_at);
  std::size_t seen = 0;
  for (const Group& pass : fit.passes) {
    profile.begin_event();
    for (const std::size_t i : pass) {
      if (seen++ % stride != 0) continue;
      const LagImage& image = fit.images[i];
      profile.add([&](double lag) { return cost_of(image, places[image.place], facts, lag); });
    }
  }
  return profile;
}

/// Finds the median error along the motion in either half of the passes, with the lag of the other half.
void judge_lag(const Profile& profile, const std::vector<BallPlace>& places, LagFit& fit) {
  std::vector<std::size_t> halves[2];
  for (std::size_t pass = 0; pass < fit.passes.size(); ++pass) halves[pass % 2].push_back(pass);
  std::vector<double> errors, uncorrected;
  for (const std::size_t half : {0U, 1U}) {
    const double lag = profile.best(halves[1 - half]);
    for (const std::size_t pass : halves[half])
      for (const std::size_t i : fit.passes[pass]) {
        const LagImage& image = fit.images[i];
        if (std::isnan(image.along)) continue;
        errors.push_back(std::abs(image.along + lag * places[image.place].speed()));
        uncorrected.push_back(std::abs(image.along));
      }
  }
  fit.error = middle_of(std::move(errors));
  fit.uncorrected = middle_of(std::move(uncorrected));
}

/// The passes of the recordings of one clock.
struct ClockPasses {
  std::vector<std::size_t> passes;
  double deviation = 0;  // [s] the greatest of the clock
};

/// Returns the lags by clock; those with few passes are left out.
std::vector<ClockLag> lags_by_clock(const Profile& profile, const LagFit& fit, const std::vector<BallPlace>& places,
                                    const std::vector<BallRecording>& recordings) {
  std::map<std::string, ClockPasses> clocks;
  for (std::size_t pass = 0; pass < fit.passes.size(); ++pass) {
    ClockPasses& clock = clocks[recordings[fit.images[fit.passes[pass].front()].recording].clock];
    clock.passes.push_back(pass);
    for (const std::size_t i : fit.passes[pass])
      clock.deviation = std::max(clock.deviation, places[fit.images[i].place].clock_deviation);
  }
  std::vector<ClockLag> lags;
  for (const auto& [name, clock] : clocks)
    if (clock.passes.size() >= kFewestPassesOfClock)
      lags.push_back({.clock = name,
                      .value = profile.best(clock.passes),
                      .deviation = profile.deviation(clock.passes),
                      .clock_deviation = clock.deviation,
                      .passes = clock.passes.size()});
  return lags;
}

/// Combines the lags: each counts by the errors of its passes and of its clock.
void combine(LagFit& fit) {
  double weights = 0, sum = 0;
  for (const ClockLag& clock : fit.clocks) {
    const double weight = 1 / std::max(1e-12, std::pow(clock.deviation, 2) + std::pow(clock.clock_deviation, 2));
    weights += weight, sum += weight * clock.value;
  }
  fit.value = sum / weights;
  fit.deviation = std::sqrt(1 / weights);
}

}  // namespace

LagFit fit_lag(const std::vector<BallPlace>& places, const std::vector<BallRecording>& recordings,
               const ImageFacts& facts, const ImageNoise& usual) {
  LagFit fit;
  collect_rolls(places, recordings, lying_errors(places, recordings.size(), facts, usual), facts, fit);
  std::vector<BallPlace> rolling;
  for (const LagImage& image : fit.images) rolling.push_back(places[image.place]);
  fit.passes = passes_of(rolling, all_of(rolling.size()));
  if (fit.passes.size() < kFewestLagPasses) return fit;
  const auto [slowest, fastest] = std::ranges::minmax_element(rolling, {}, &BallPlace::speed);
  fit.slowest = slowest->speed(), fit.fastest = fastest->speed();
  const Profile profile = lag_profile(fit, places, facts);
  fit.clocks = lags_by_clock(profile, fit, places, recordings);
  fit.known = !fit.clocks.empty();
  if (!fit.known) return fit;
  combine(fit);
  judge_lag(profile, places, fit);
  return fit;
}

}  // namespace robot::fit
