#include "robot/fit/ball_noise/ball_noise.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <utility>

#include "robot/core/text.h"
#include "robot/fit/ball_noise/image_noise.h"
#include "robot/fit/ball_noise/noise_pictures.h"
#include "robot/fit/ball_noise/profile.h"
#include "robot/fit/math/angles.h"
#include "robot/lab/clocks/belief_error.h"

namespace robot::fit {
namespace {

constexpr double kWidestNoise = 0.005;  // [rad] half an interval that is worth more than an estimate
constexpr double kWantedNoise = 0.002;  // [rad] a tenth of the usual values
constexpr std::size_t kNoisePassesWanted = 30;
constexpr std::array kDistanceEdges{0.0, 0.5, 1.0, 2.0, 3.0, 4.5, 6.0, 30.0};  // [m]
constexpr double kRadian = 180 / std::numbers::pi;                             // [°]
const char* const kTiltAdvice =
    "balls that lie 1 to 2.5 m away, the robot in sight of the truth, in games or on a training field";
const char* const kRollAdvice =
    "balls that lie 1.5 m away or more, beside a truth with headings (tags or a simulated game)";

/// One parameter with its name in the models.
struct NamedNoise {
  const char* name;
  const NoiseParameter& parameter;
  std::string reason;  // why it may be absent
  const char* advice;
};

/// Formats the lack of images: "expected at least 40 images of a ball that lies, by a robot that walks, in 8 passes,
/// got 3 in 1".
std::string too_few(const char* which, const NoiseParameter& parameter) {
  return formatted("expected at least 40 images of a ball that lies, %s, in 8 passes, got %zu in %zu", which,
                   parameter.images, parameter.passes);
}

std::string reason_of_gait(const BallPlaces& places, const char* which, const NoiseParameter& parameter) {
  if (!places.percepts.empty() && !std::ranges::any_of(places.recordings, &BallRecording::has_gait))
    return "expected the motion status of the robots, got no message";
  return too_few(which, parameter);
}

std::string reason_of_roll(const BallPlaces& places, const NoiseParameter& parameter) {
  if (!places.percepts.empty() && places.headless == places.percepts.size())
    return "expected headings of the robots in the truth, got no heading";
  return too_few("beside a true heading", parameter);
}

std::vector<std::string> names_of(const BallPlaces& places) {
  std::vector<std::string> names;
  for (const BallRecording& recording : places.recordings) names.push_back(recording.name);
  return names;
}

Figure noise_figure(const NamedNoise& named, const BallPlaces& places) {
  const NoiseParameter& fitted = named.parameter;
  const double half = two_sided(fitted.passes - 1) * fitted.deviation;
  return {.name = named.name,
          .unit = "rad",
          .value = fitted.value,
          .low = std::max(0., fitted.value - half),
          .high = fitted.value + half,
          .events = fitted.passes,
          .kind = "passes",
          .recordings = names_of(places),
          .domain = {.quantity = "true distance", .unit = "m", .from = fitted.nearest, .to = fitted.farthest},
          .widest = kWidestNoise};
}

void add_parameters(const ImageNoiseFit& fit, const BallPlaces& places, Report& report) {
  const NamedNoise all[] = {
      {"noise.tilt", fit.tilt, reason_of_gait(places, "by a robot that stands", fit.tilt), kTiltAdvice},
      {"noise.tilt_walking", fit.tilt_walking, reason_of_gait(places, "by a robot that moves", fit.tilt_walking),
       kTiltAdvice},
      {"noise.roll", fit.roll, reason_of_roll(places, fit.roll), kRollAdvice}};
  for (const NamedNoise& named : all) {
    if (named.parameter.known) {
      report.figures.push_back(noise_figure(named, places));
      report.needs.push_back(need_of(report.figures.back(), kWantedNoise, named.advice));
    } else {
      report.kept.push_back(std::string(named.name) + ": " + named.reason);
      report.needs.push_back(need_of(named.name, "passes", named.parameter.passes, kNoisePassesWanted, named.advice));
    }
  }
}

/// Returns the figure of a bias: the median over the passes of the median in each.
template <class ErrorOf>
std::optional<Figure> bias_figure(const char* name, const char* unit, const ImageNoiseFit& fit,
                                  const BallPlaces& places, ErrorOf&& error_of) {
  std::vector<double> of_passes;
  double nearest = INFINITY, farthest = 0;
  for (const Group& pass : fit.passes) {
    std::vector<double> errors;
    for (const std::size_t i : pass) {
      const double error = error_of(fit.errors[i]);
      if (std::isnan(error)) continue;
      errors.push_back(error);
      nearest = std::min(nearest, fit.errors[i].distance), farthest = std::max(farthest, fit.errors[i].distance);
    }
    if (!errors.empty()) of_passes.push_back(middle_of(std::move(errors)));
  }
  if (of_passes.size() < 8) return std::nullopt;
  const auto samples = resampled(single_groups(of_passes.size()), 200, [&](const std::vector<std::size_t>& chosen) {
    std::vector<double> values;
    for (const std::size_t i : chosen) values.push_back(of_passes[i]);
    return Vector{middle_of(std::move(values))};
  });
  const double half = two_sided(of_passes.size() - 1) * deviations_of(samples)[0];
  const std::size_t passes = of_passes.size();
  const double value = middle_of(std::move(of_passes));
  return Figure{.name = name,
                .unit = unit,
                .value = value,
                .low = value - half,
                .high = value + half,
                .events = passes,
                .kind = "passes",
                .recordings = names_of(places),
                .domain = {.quantity = "true distance", .unit = "m", .from = nearest, .to = farthest}};
}

void add_biases(const ImageNoiseFit& fit, const BallPlaces& places, Report& report) {
  const auto range = [&](const ImageError& error) {
    return std::isnan(error.elevation) ? NAN : places.percepts[error.place].seen_distance / error.distance - 1;
  };
  const auto bearing = [](const ImageError& error) { return error.bearing; };
  if (auto figure = bias_figure("ball_noise.range_bias", "", fit, places, range)) report.figures.push_back(*figure);
  if (auto figure = bias_figure("ball_noise.bearing_bias", "rad", fit, places, bearing))
    report.figures.push_back(*figure);
  Results results{.title = "median errors of each recording",
                  .head = {"recording", "images", "elevation [°]", "bearing [°]"},
                  .rows = {}};
  for (std::size_t i = 0; i < fit.biases.size(); ++i)
    results.rows.push_back({places.recordings[i].name, formatted("%zu", fit.biases[i].images),
                            formatted("%+.2f", kRadian * fit.biases[i].elevation),
                            formatted("%+.2f", kRadian * fit.biases[i].bearing)});
  report.results.push_back(std::move(results));
}

/// Returns one score over both gaits.
NoiseScore both_gaits(const NoiseScore (&of)[2]) {
  const auto moving = static_cast<double>(of[0].images), standing = static_cast<double>(of[1].images);
  const double all = std::max(1., moving + standing);
  return {.images = of[0].images + of[1].images,
          .covered = (moving * of[0].covered + standing * of[1].covered) / all,
          .log_score = (moving * of[0].log_score + standing * of[1].log_score) / all};
}

void add_scores(const NoiseScores& scores, Report& report) {
  const NoiseScore fitted = both_gaits(scores.fitted), other = both_gaits(scores.other);
  if (fitted.images == 0) return;
  Results results{.title = "images held out: share in the region of 90 %, and log score of the density [1/rad²]",
                  .head = {"robot", "images", "fitted", "before", "fitted score", "score before"},
                  .rows = {}};
  const auto add = [&](const char* robot, const NoiseScore& ours, const NoiseScore& before) {
    if (ours.images == 0) return;
    results.rows.push_back({robot, formatted("%zu", ours.images), formatted("%.1f %%", 100 * ours.covered),
                            formatted("%.1f %%", 100 * before.covered), formatted("%.3f", ours.log_score),
                            formatted("%.3f", before.log_score)});
  };
  add("stands", scores.fitted[1], scores.other[1]);
  add("moves", scores.fitted[0], scores.other[0]);
  add("both", fitted, other);
  report.results.push_back(std::move(results));
  report.scores.emplace_back("covered_90", fitted.covered);
  report.scores.emplace_back("log_score", fitted.log_score);
  report.scores.emplace_back("log_score_before", other.log_score);
}

/// Returns the distance [m] between the seen and the true place of the ball, relative to the robot; of the range
/// alone without a true heading.
double place_error(const BallPlace& place) {
  if (std::isnan(place.bearing)) return std::abs(place.seen_distance - place.distance);
  const double turn = wrapped(place.seen_bearing - place.bearing);
  const double chord = 2 * std::sin(turn / 2);
  return std::sqrt(std::pow(place.seen_distance - place.distance, 2) +
                   place.seen_distance * place.distance * chord * chord);
}

void add_errors_over_distance(const char* who, const std::vector<BallPlace>& places, Results& results) {
  for (std::size_t bin = 0; bin + 1 < kDistanceEdges.size(); ++bin) {
    std::vector<double> errors;
    for (const BallPlace& place : places)
      if (place.distance >= kDistanceEdges[bin] && place.distance < kDistanceEdges[bin + 1])
        errors.push_back(place_error(place));
    if (errors.empty()) continue;
    const lab::ErrorFigures figures = lab::figures_of(std::move(errors));
    results.rows.push_back({who, formatted("%.1f-%.1f", kDistanceEdges[bin], kDistanceEdges[bin + 1]),
                            formatted("%zu", figures.samples), formatted("%.1f", 100 * figures.mean),
                            formatted("%.1f", 100 * figures.median), formatted("%.1f", 100 * figures.p95)});
  }
}

Table table_of_errors(const ImageNoiseFit& fit, const BallPlaces& places) {
  Table table{.columns = {"time [s]", "stands", "true distance [m]", "seen distance [m]", "error of elevation [rad]",
                          "deviation by the truth [rad]", "error of bearing [rad]", "deviation by the truth [rad]"},
              .names = names_of(places),
              .rows = {}};
  for (const ImageError& error : fit.errors) {
    const BallPlace& place = places.percepts[error.place];
    table.rows.push_back({.recording = error.recording,
                          .values = {place.at, error.standing ? 1. : 0., place.distance, place.seen_distance,
                                     error.elevation, error.of_elevation, error.bearing, error.of_bearing}});
  }
  return table;
}

void add_notes(const ImageNoiseFit& fit, const BallPlaces& places, const ImageFacts& facts, Report& report) {
  report.notes.push_back(
      formatted("noise.pixels stays: %.4f rad of each error are left to it, because pixels and tilt "
                "cannot be distinguished",
                facts.pixels));
  report.notes.push_back(
      formatted("left out: %zu percepts of balls that moved, %zu of robots with an unknown motion or down, %zu without "
                "truth, %zu damaged",
                fit.moving, fit.without_gait, places.without_truth, places.damaged));
  report.notes.push_back(formatted(
      "left out: %zu distances near the horizon, where others are lost behind it; %zu where the truth's error "
      "is most of it; %zu bearings of robots that turn, where the clock's error is",
      fit.beyond, fit.close, fit.turning));
  double scatter = 0;
  for (const BallRecording& recording : places.recordings) scatter = std::max(scatter, recording.heading_scatter);
  report.notes.push_back(
      formatted("true headings differ by %.4f rad from place to place, which is subtracted; a slower error of them is "
                "contained in noise.roll, a constant one in the bias",
                scatter));
  report.notes.emplace_back("the simulator has no bias: the noise is that around the median of each recording");
}

}  // namespace

Report fit_ball_noise(const BallPlaces& places, const sim::Models& base) {
  Report report{.name = "ball_noise", .title = "How well the robots place the ball"};
  const ImageFacts facts = image_facts(base);
  const sim::perception::Noise& before = base.perception.noise;
  const ImageNoiseFit fit =
      fit_image_noise(places, facts, {.tilt = before.tilt, .tilt_walking = before.tilt_walking, .roll = before.roll});
  add_parameters(fit, places, report);
  if (places.percepts.empty() && places.beliefs.empty()) return report;
  add_biases(fit, places, report);
  add_scores(fit.scores, report);
  Results errors{.title = "errors of the ball's place relative to the robot [cm], over its true distance",
                 .head = {"by", "distance [m]", "images", "mean", "median", "95 %"},
                 .rows = {}};
  add_errors_over_distance("percept", places.percepts, errors);
  add_errors_over_distance("belief", places.beliefs, errors);
  report.results.push_back(std::move(errors));
  if (fit.tilt.known || fit.tilt_walking.known)
    report.pictures.push_back(range_picture(fit, places, facts, before.tilt_walking));
  if (fit.roll.known) report.pictures.push_back(bearing_picture(fit, facts, before.roll));
  report.tables.emplace_back("ball_noise", table_of_errors(fit, places));
  add_notes(fit, places, facts, report);
  return report;
}

Report fit_ball_noise(const Evidence& evidence, const sim::Models& base) {
  return fit_ball_noise(read_ball_places(evidence), base);
}

}  // namespace robot::fit
