#include "robot/fit/ball_noise/image_noise.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>

#include "robot/fit/ball_noise/profile.h"
#include "robot/fit/math/angles.h"

namespace robot::fit {
namespace {

constexpr double kLying = 0.1;           // [m/s] a slower ball lies; the latency displaces it by less than 1 cm
constexpr double kMostKnown = 0.01;      // [rad] error of the truth in a usable image
constexpr double kMostByClock = 0.005;   // [rad] error of the clock in a usable image
constexpr double kPilotElevation = 0.2;  // [rad] far from the horizon: 2 m away
constexpr double kFromHorizon = 3.5;     // standard deviations
constexpr double kFalseShare = 0.001;  // of false balls, which lie anywhere in the view; a larger one narrows the noise
constexpr double kFalseDensity = 1;    // [1/rad] of their errors
constexpr double kLeastNoise = 0.0005;    // [rad] first value of the grid
constexpr double kNoiseStep = 1.05;       // between two values
constexpr std::size_t kNoiseSteps = 124;  // up to 0.2 rad
constexpr std::size_t kFewestNoiseImages = 40, kFewestNoisePasses = 8;
constexpr std::size_t kMostNoiseImages = 40'000;  // of one parameter: more would only take longer
constexpr std::size_t kNoiseParts = 5;
constexpr double kRegionOf90 = 4.605;  // squared standard deviations of two axes

double normal_density(double error, double variance) {
  return std::exp(-error * error / (2 * variance)) / std::sqrt(2 * std::numbers::pi * variance);
}

/// Returns the density of an error that may be that of a false ball.
double density_of(double error, double variance) {
  return (1 - kFalseShare) * normal_density(error, variance) + kFalseShare * kFalseDensity;
}

double squared_of(double value) { return value * value; }

/// Returns one robust standard deviation of the values around their median.
double robust_deviation(std::vector<double> values) {
  const double middle = middle_of(values);
  for (double& value : values) value = std::abs(value - middle);
  return kOfMedian * middle_of(std::move(values));
}

/// Returns the errors of a percept; those that are not usable are NaN.
ImageError error_of(const BallPlace& place, std::size_t index, double height, ImageNoiseFit& fit) {
  const double per_metre = height / (place.distance * place.distance + height * height);
  const double heading = std::hypot(place.deviation / place.distance, place.heading_deviation);
  const double elevation_by_clock = std::abs(per_metre * place.distance_rate) * place.clock_deviation;
  const double bearing_by_clock = std::abs(place.bearing_rate) * place.clock_deviation;
  ImageError error{.place = index,
                   .recording = place.recording,
                   .standing = place.gait == Gait::standing,
                   .distance = place.distance,
                   .elevation = elevation_at(place.seen_distance, height) - elevation_at(place.distance, height),
                   .bearing = wrapped(place.seen_bearing - place.bearing),
                   .of_elevation = std::hypot(per_metre * place.deviation, elevation_by_clock),
                   .of_bearing = std::hypot(heading, bearing_by_clock),
                   .elevation_by_clock = elevation_by_clock,
                   .bearing_by_clock = bearing_by_clock};
  const bool is_close = per_metre * place.deviation > kMostKnown, turns = bearing_by_clock > kMostByClock;
  fit.close += is_close;
  fit.turning += turns;
  if (is_close || elevation_by_clock > kMostByClock) error.elevation = NAN;
  if (turns || place.deviation / place.distance > kMostKnown) error.bearing = NAN;
  return error;
}

void collect(const BallPlaces& places, double height, ImageNoiseFit& fit) {
  for (std::size_t i = 0; i < places.percepts.size(); ++i) {
    const BallPlace& place = places.percepts[i];
    if (place.speed() > kLying + 2 * place.speed_deviation) {
      ++fit.moving;
    } else if (place.gait != Gait::standing && place.gait != Gait::moving) {
      ++fit.without_gait;
    } else {
      const ImageError error = error_of(place, i, height, fit);
      if (!std::isnan(error.elevation) || !std::isnan(error.bearing)) fit.errors.push_back(error);
    }
  }
}

/// Returns the finite errors of one gait that `counts`.
template <class Counts>
std::vector<double> elevations(const std::vector<ImageError>& errors, Counts&& counts) {
  std::vector<double> found;
  for (const ImageError& error : errors)
    if (!std::isnan(error.elevation) && counts(error)) found.push_back(error.elevation);
  return found;
}

/// Leaves out elevations so near to the horizon that some of the like have no percept. The noise is that of nearer
/// balls.
void leave_out_horizon(const ImageFacts& facts, ImageNoiseFit& fit) {
  const double lost = elevation_at(2 * facts.far_range, facts.height);
  for (const bool standing : {false, true}) {
    const auto of_gait = [&](const ImageError& error) { return error.standing == standing; };
    std::vector<double> pilot = elevations(fit.errors, [&](const ImageError& error) {
      return of_gait(error) && elevation_at(error.distance, facts.height) > kPilotElevation;
    });
    if (pilot.size() < kFewestNoiseImages) pilot = elevations(fit.errors, of_gait);
    const double least = lost + kFromHorizon * robust_deviation(std::move(pilot));
    for (ImageError& error : fit.errors) {
      if (!of_gait(error) || std::isnan(error.elevation) || elevation_at(error.distance, facts.height) >= least)
        continue;
      error.elevation = NAN;
      ++fit.beyond;
    }
  }
}

void find_biases(std::size_t recordings, ImageNoiseFit& fit) {
  std::vector<std::vector<double>> elevations(recordings), bearings(recordings);
  fit.biases.assign(recordings, {});
  for (const ImageError& error : fit.errors) {
    if (!std::isnan(error.elevation)) elevations[error.recording].push_back(error.elevation);
    if (!std::isnan(error.bearing)) bearings[error.recording].push_back(error.bearing);
    ++fit.biases[error.recording].images;
  }
  for (std::size_t i = 0; i < recordings; ++i) {
    fit.biases[i].elevation = middle_of(std::move(elevations[i]));
    fit.biases[i].bearing = middle_of(std::move(bearings[i]));
  }
}

/// One axis of some images.
struct NoiseAxis {
  double ImageError::*error;
  double ImageError::*known;
  double ImageError::*by_clock;
  double ImageBias::*bias;
};
constexpr NoiseAxis kElevationAxis{&ImageError::elevation, &ImageError::of_elevation, &ImageError::elevation_by_clock,
                                   &ImageBias::elevation};
constexpr NoiseAxis kBearingAxis{&ImageError::bearing, &ImageError::of_bearing, &ImageError::bearing_by_clock,
                                 &ImageBias::bearing};

double noise_at(double place) { return kLeastNoise * std::pow(kNoiseStep, place); }

/// The likelihood of one parameter, with the passes and images behind it.
struct NoiseProfile {
  Profile profile{kNoiseSteps, noise_at};
  std::vector<std::size_t> passes;  // of each event: its index in fit.passes
  double by_clock = 0;              // [rad²] mean variance by the clock
  NoiseParameter facts;
};

/// Returns the profile of an axis over the images that `counts`.
template <class Counts>
NoiseProfile profile_of(const ImageNoiseFit& fit, const NoiseAxis& axis, double pixels, Counts&& counts) {
  const auto usable = [&](const ImageError& error) { return counts(error) && !std::isnan(error.*axis.error); };
  const auto images = static_cast<std::size_t>(std::ranges::count_if(fit.errors, usable));
  const std::size_t stride = 1 + images / kMostNoiseImages;
  NoiseProfile found{.facts = {.images = images, .nearest = INFINITY}};
  std::size_t seen = 0, used = 0;
  for (std::size_t pass = 0; pass < fit.passes.size(); ++pass) {
    bool begun = false;
    for (const std::size_t i : fit.passes[pass]) {
      const ImageError& error = fit.errors[i];
      if (!usable(error)) continue;
      found.facts.nearest = std::min(found.facts.nearest, error.distance);
      found.facts.farthest = std::max(found.facts.farthest, error.distance);
      if (seen++ % stride != 0) continue;
      if (!begun) found.profile.begin_event(), found.passes.push_back(pass), begun = true;
      ++used;
      found.by_clock += squared_of(error.*axis.by_clock);
      const double known = squared_of(error.*axis.known) + pixels * pixels;
      const double around = error.*axis.error - fit.biases[error.recording].*axis.bias;
      found.profile.add([&](double noise) { return -std::log(density_of(around, noise * noise + known)); });
    }
  }
  found.facts.passes = found.profile.events();
  found.by_clock /= std::max(1., static_cast<double>(used));
  return found;
}

/// The profiles of the three parameters.
struct NoiseProfiles {
  NoiseProfile tilt, tilt_walking, roll;
};

NoiseProfiles profiles_of(const ImageNoiseFit& fit, double pixels) {
  return {
      .tilt = profile_of(fit, kElevationAxis, pixels, [](const ImageError& error) { return error.standing; }),
      .tilt_walking = profile_of(fit, kElevationAxis, pixels, [](const ImageError& error) { return !error.standing; }),
      .roll = profile_of(fit, kBearingAxis, pixels, [](const ImageError&) { return true; })};
}

NoiseParameter parameter_of(const NoiseProfile& found) {
  NoiseParameter parameter = found.facts;
  parameter.known = parameter.images >= kFewestNoiseImages && parameter.passes >= kFewestNoisePasses;
  if (!parameter.known) return parameter;
  const Group all = all_of(found.profile.events());
  parameter.value = found.profile.best(all);
  // The clock has one error, whose square is known no better than √2 of its expectation; that goes into the noise's variance.
  const double missed_by_clock = std::numbers::sqrt2 * found.by_clock / (2 * parameter.value);
  parameter.deviation = std::hypot(found.profile.deviation(all), missed_by_clock);
  return parameter;
}

/// Returns the parts of the passes that are held out in turn.
std::vector<std::size_t> parts_of_passes(const ImageNoiseFit& fit) {
  const auto of_pass = [&](std::size_t pass) { return fit.errors[fit.passes[pass].front()].recording; };
  const bool several = of_pass(0) != of_pass(fit.passes.size() - 1);
  std::vector<std::size_t> parts;
  for (std::size_t pass = 0; pass < fit.passes.size(); ++pass)
    parts.push_back(several ? of_pass(pass) : pass * kNoiseParts / fit.passes.size());
  return parts;
}

/// Returns the fitted value of a profile without one part, or nothing if no event is left.
std::optional<double> value_without(const NoiseProfile& found, const std::vector<std::size_t>& parts,
                                    std::size_t part) {
  std::vector<std::size_t> others;
  for (std::size_t event = 0; event < found.passes.size(); ++event)
    if (parts[found.passes[event]] != part) others.push_back(event);
  if (others.empty()) return std::nullopt;
  return found.profile.best(others);
}

void add_score(const ImageError& error, const ImageBias& bias, const ImageNoise& noise, double pixels,
               NoiseScore& score) {
  const double tilt = error.standing ? noise.tilt : noise.tilt_walking;
  const double up = tilt * tilt + pixels * pixels + squared_of(error.of_elevation);
  const double aside = noise.roll * noise.roll + pixels * pixels + squared_of(error.of_bearing);
  const double elevation = error.elevation - bias.elevation, bearing = error.bearing - bias.bearing;
  ++score.images;
  score.covered += squared_of(elevation) / up + squared_of(bearing) / aside <= kRegionOf90;
  score.log_score += std::log(density_of(elevation, up) * density_of(bearing, aside));
}

void finish(NoiseScore& score) {
  if (score.images == 0) return;
  score.covered /= static_cast<double>(score.images);
  score.log_score /= static_cast<double>(score.images);
}

NoiseScores scores_of(const ImageNoiseFit& fit, const NoiseProfiles& profiles, double pixels, const ImageNoise& other) {
  NoiseScores scores;
  if (fit.passes.empty()) return scores;
  const std::vector<std::size_t> parts = parts_of_passes(fit);
  for (std::size_t part = 0; part <= *std::ranges::max_element(parts); ++part) {
    const auto tilt = value_without(profiles.tilt, parts, part);
    const auto tilt_walking = value_without(profiles.tilt_walking, parts, part);
    const auto roll = value_without(profiles.roll, parts, part);
    for (std::size_t pass = 0; pass < parts.size(); ++pass) {
      if (parts[pass] != part) continue;
      for (const std::size_t i : fit.passes[pass]) {
        const ImageError& error = fit.errors[i];
        const auto& own_tilt = error.standing ? tilt : tilt_walking;
        if (std::isnan(error.elevation) || std::isnan(error.bearing) || !own_tilt || !roll) continue;
        const ImageNoise fitted{.tilt = *own_tilt, .tilt_walking = *own_tilt, .roll = *roll};
        const ImageBias& bias = fit.biases[error.recording];
        add_score(error, bias, fitted, pixels, scores.fitted[error.standing]);
        add_score(error, bias, other, pixels, scores.other[error.standing]);
      }
    }
  }
  for (const bool standing : {false, true}) finish(scores.fitted[standing]), finish(scores.other[standing]);
  return scores;
}

}  // namespace

ImageFacts image_facts(const sim::Models& base) {
  const sim::perception::Model& model = base.perception;
  return {.height = double(model.camera.height) - double(base.ball.radius),
          .pixels = double(model.noise.pixels) * double(model.camera.pixel_angle),
          .far_range = model.ball.far_range,
          .deceleration = base.ball.deceleration};
}

double elevation_at(double distance, double height) { return std::atan2(height, distance); }

double distance_at(double elevation, double height) {
  return elevation > 0 ? height / std::tan(elevation) : static_cast<double>(INFINITY);
}

ImageNoiseFit fit_image_noise(const BallPlaces& places, const ImageFacts& facts, const ImageNoise& other) {
  ImageNoiseFit fit;
  collect(places, facts.height, fit);
  leave_out_horizon(facts, fit);
  std::erase_if(fit.errors,
                [](const ImageError& error) { return std::isnan(error.elevation) && std::isnan(error.bearing); });
  find_biases(places.recordings.size(), fit);
  // passes of places, as indices of their errors
  std::vector<BallPlace> usable;
  for (const ImageError& error : fit.errors) usable.push_back(places.percepts[error.place]);
  fit.passes = passes_of(usable, all_of(usable.size()));
  const NoiseProfiles profiles = profiles_of(fit, facts.pixels);
  fit.tilt = parameter_of(profiles.tilt);
  fit.tilt_walking = parameter_of(profiles.tilt_walking);
  fit.roll = parameter_of(profiles.roll);
  fit.scores = scores_of(fit, profiles, facts.pixels, other);
  return fit;
}

}  // namespace robot::fit
