#include "robot/fit/ball_noise/noise_pictures.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <string>
#include <utility>
#include <vector>

namespace robot::fit {
namespace {

constexpr std::size_t kBandPoints = 50;
constexpr double kDegrees = 180 / std::numbers::pi;

/// Returns the errors with a number on this axis.
std::vector<const ImageError*> drawn_errors(const ImageNoiseFit& fit, double ImageError::*axis) {
  std::vector<const ImageError*> drawn;
  for (const ImageError& error : fit.errors)
    if (!std::isnan(error.*axis)) drawn.push_back(&error);
  return drawn;
}

double farthest_of(const std::vector<const ImageError*>& errors) {
  double farthest = 0;
  for (const ImageError* error : errors) farthest = std::max(farthest, error->distance);
  return farthest;
}

/// Returns a band of one standard deviation: from `low` to `high` at each distance.
template <class Low, class High>
Mark band_of(const std::string& label, double nearest, double farthest, Low&& low, High&& high) {
  Mark band{.shape = Mark::Shape::band, .role = Mark::Role::fitted, .label = label};
  for (std::size_t i = 0; i < kBandPoints; ++i) {
    const double distance = nearest + (farthest - nearest) * static_cast<double>(i) / (kBandPoints - 1);
    band.x.push_back(distance);
    band.y.push_back(low(distance));
    band.high.push_back(high(distance));
  }
  return band;
}

/// Returns the two edges of a band as lines; only the first has the label.
void add_edges(const Mark& band, Mark::Role role, const std::string& label, std::vector<Mark>& marks) {
  marks.push_back({.shape = Mark::Shape::line, .role = role, .label = label, .x = band.x, .y = band.y});
  marks.push_back({.shape = Mark::Shape::line, .role = role, .label = "", .x = band.x, .y = band.high});
}

Mark dots_of(const std::vector<const ImageError*>& errors, const std::vector<double>& values) {
  Mark dots{.shape = Mark::Shape::dots, .role = Mark::Role::robot, .label = "percept"};
  for (const ImageError* error : errors) dots.x.push_back(error->distance);
  dots.y = values;
  return dots;
}

}  // namespace

Picture range_picture(const ImageNoiseFit& fit, const BallPlaces& places, const ImageFacts& facts, double before) {
  const auto errors = drawn_errors(fit, &ImageError::elevation);
  const double farthest = farthest_of(errors);
  std::vector<double> values;
  for (const ImageError* error : errors)
    values.push_back(places.percepts[error->place].seen_distance - error->distance);
  const auto band = [&](double tilt) {
    const double sigma = std::hypot(tilt, facts.pixels);
    const auto shifted = [&, sigma](double sign) {
      return [&facts, sigma, sign](double distance) {
        return distance_at(elevation_at(distance, facts.height) + sign * sigma, facts.height) - distance;
      };
    };
    return band_of("± one standard deviation, fitted", 0.1, farthest, shifted(1), shifted(-1));
  };
  Picture picture{.title = "Error of the distance",
                  .x_label = "true distance [m]",
                  .y_label = "seen - true [m]",
                  .axes = {.left = 0, .right = farthest, .bottom = -1, .top = 1},
                  .marks = {}};
  const auto& fitted = fit.tilt_walking.known ? fit.tilt_walking : fit.tilt;
  if (fitted.known) picture.marks.push_back(band(fitted.value));
  picture.marks.push_back(dots_of(errors, values));
  if (fit.tilt_walking.known)
    add_edges(band(fit.tilt_walking.value), Mark::Role::fitted, "fitted, it moves", picture.marks);
  if (fit.tilt.known) add_edges(band(fit.tilt.value), Mark::Role::truth, "fitted, it stands", picture.marks);
  add_edges(band(before), Mark::Role::other, "before, it moves", picture.marks);
  return picture;
}

Picture bearing_picture(const ImageNoiseFit& fit, const ImageFacts& facts, double before) {
  const auto errors = drawn_errors(fit, &ImageError::bearing);
  const double farthest = farthest_of(errors);
  std::vector<double> values;
  for (const ImageError* error : errors) values.push_back(kDegrees * error->bearing);
  const auto band = [&](double roll) {
    const double sigma = kDegrees * std::hypot(roll, facts.pixels);
    return band_of(
        "± one standard deviation, fitted", 0, farthest, [sigma](double) { return -sigma; },
        [sigma](double) { return sigma; });
  };
  Picture picture{.title = "Error of the bearing",
                  .x_label = "true distance [m]",
                  .y_label = "seen - true [°]",
                  .axes = {.left = 0, .right = farthest, .bottom = -8, .top = 8},
                  .marks = {}};
  if (fit.roll.known) picture.marks.push_back(band(fit.roll.value));
  picture.marks.push_back(dots_of(errors, values));
  if (fit.roll.known) add_edges(band(fit.roll.value), Mark::Role::fitted, "fitted", picture.marks);
  add_edges(band(before), Mark::Role::other, "before", picture.marks);
  return picture;
}

}  // namespace robot::fit
