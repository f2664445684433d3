#include "robot/fit/ball_noise/latency.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "robot/core/text.h"
#include "robot/fit/ball_noise/lag.h"
#include "robot/fit/ball_noise/profile.h"
#include "sim/math/tick.h"

namespace robot::fit {
namespace {

constexpr double kMostLatency = 0.1;     // [s] of the model
constexpr double kWidestLatency = 0.02;  // [s] half an interval that is worth more than an estimate
constexpr double kWantedLatency = 0.01;  // [s]
constexpr std::size_t kLagPassesWanted = 20;
constexpr double kSpeedBin = 0.2;  // [m/s]
const char* const kLatencyAdvice = "balls that roll at 0.5 m/s or more past a robot, beside a truth with headings";

Figure lag_figure(const char* name, const LagFit& fit, const std::vector<BallRecording>& recordings) {
  const double half = two_sided(fit.passes.size() - 1) * fit.deviation;
  std::vector<std::string> names;
  for (const BallRecording& recording : recordings)
    if (!recording.clock_by_ball) names.push_back(recording.name);
  return {.name = name,
          .unit = "s",
          .value = fit.value,
          .low = fit.value - half,
          .high = fit.value + half,
          .events = fit.passes.size(),
          .kind = "passes of rolling balls",
          .recordings = std::move(names),
          .domain = {.quantity = "speed", .unit = "m/s", .from = fit.slowest, .to = fit.fastest}};
}

/// Returns the time until the writing, or nothing if no recording shows it. It differs between robots by luck.
std::optional<Figure> publish_figure(const std::vector<BallRecording>& recordings) {
  std::vector<std::string> names;
  std::vector<double> times;
  for (const BallRecording& recording : recordings) {
    if (!recording.writing) continue;
    times.push_back(*recording.writing);
    names.push_back(recording.name);
  }
  if (times.empty()) return std::nullopt;
  const auto count = static_cast<double>(times.size());
  double sum = 0, squares = 0;
  for (const double time : times) sum += time;
  for (const double time : times) squares += std::pow(time - sum / count, 2);
  const double half = times.size() > 1 ? two_sided(times.size() - 1) * std::sqrt(squares / (count - 1) / count) : 0;
  const auto [least, most] = std::ranges::minmax(times);
  return Figure{.name = "latency.publish",
                .unit = "s",
                .value = sum / count,
                .low = sum / count - half,
                .high = sum / count + half,
                .events = times.size(),
                .kind = "recordings",
                .recordings = std::move(names),
                .domain = {.quantity = "time", .unit = "s", .from = least, .to = most}};
}

std::string reason_of_lag(const BallPlaces& places, const LagFit& fit) {
  if (places.percepts.empty()) return "expected percepts of the ball, got no image with a true place";
  if (fit.images.empty() && fit.by_ball > 0)
    return "expected clocks that were compared by samples, got clocks that were compared by the ball, which hides the "
           "lag";
  return formatted("expected at least 8 passes of balls that roll at 0.4 m/s or more, got %zu", fit.passes.size());
}

/// Returns the whole latency as a figure of the models, or as one that is only reported if the models cannot have it.
Figure total_figure(const Figure& percept, const std::optional<Figure>& publish, Report& report) {
  Figure total = percept;
  total.name = "camera.latency";
  total.widest = kWidestLatency;
  if (publish) {
    const double half = std::hypot((percept.high - percept.low) / 2, (publish->high - publish->low) / 2);
    total.value += publish->value;
    total.low = total.value - half, total.high = total.value + half;
  }
  if (total.low <= kMostLatency && total.high >= 0) {
    // a value that is only by chance outside is on the border
    total.value = std::clamp(total.value, 0., kMostLatency);
    return total;
  }
  report.kept.push_back(formatted("camera.latency: expected 0 to %.1f s, got %.3f s (95 %%: %.3f .. %.3f)",
                                  kMostLatency, total.value, total.low, total.high));
  total.name = "latency.total";
  return total;
}

Mark line_of_lag(Mark::Role role, const std::string& label, double lag, double fastest) {
  return {.shape = Mark::Shape::line, .role = role, .label = label, .x = {0, fastest}, .y = {0, -lag * fastest}};
}

/// Returns the median errors of balls of about the same speed.
Mark medians_over_speed(const LagFit& fit, const std::vector<BallPlace>& places) {
  Mark medians{.shape = Mark::Shape::dots, .role = Mark::Role::truth, .label = "median of a speed"};
  for (double from = 0; from < fit.fastest; from += kSpeedBin) {
    std::vector<double> errors;
    for (const LagImage& image : fit.images) {
      const double speed = places[image.place].speed();
      if (speed >= from && speed < from + kSpeedBin && !std::isnan(image.along)) errors.push_back(image.along);
    }
    if (errors.size() < 10) continue;
    medians.x.push_back(from + kSpeedBin / 2);
    medians.y.push_back(middle_of(std::move(errors)));
  }
  return medians;
}

Picture latency_picture(const LagFit& fit, const std::vector<BallPlace>& places, double before) {
  Mark dots{.shape = Mark::Shape::dots, .role = Mark::Role::robot, .label = "percept"};
  for (const auto& image : fit.images) {
    if (std::isnan(image.along)) continue;
    dots.x.push_back(places[image.place].speed());
    dots.y.push_back(image.along);
  }
  const double reach = 0.2 + 0.2 * fit.fastest;
  return {
      .title = "Error of the ball's place along its motion",
      .x_label = "true speed [m/s]",
      .y_label = "seen - true [m]",
      .axes = {.left = 0, .right = fit.fastest, .bottom = -reach, .top = reach},
      .marks = {std::move(dots), line_of_lag(Mark::Role::other, "before", before, fit.fastest),
                line_of_lag(Mark::Role::fitted, "fitted", fit.value, fit.fastest), medians_over_speed(fit, places)}};
}

void add_results(const LagFit& fit, const LagFit& belief, Report& report) {
  Results errors{.title = "median error along the motion [cm], in the half of the passes that was held out",
                 .head = {"of", "images", "as it is", "moved on by the lag"},
                 .rows = {}};
  const auto add = [&](const char* of, const LagFit& lag) {
    if (lag.known)
      errors.rows.push_back({of, formatted("%zu", lag.images.size()), formatted("%.1f", 100 * lag.uncorrected),
                             formatted("%.1f", 100 * lag.error)});
  };
  add("percept", fit);
  add("belief", belief);
  report.results.push_back(std::move(errors));
  Results clocks{.title = "lag of the percepts by each clock [ms]",
                 .head = {"clock", "passes", "lag", "deviation by luck", "by the clock"},
                 .rows = {}};
  for (const ClockLag& clock : fit.clocks) {
    const std::size_t slash = clock.clock.rfind('/');
    clocks.rows.push_back({clock.clock.empty() ? "that of the truth" : clock.clock.substr(slash + 1),
                           formatted("%zu", clock.passes), formatted("%.1f", 1000 * clock.value),
                           formatted("%.1f", 1000 * clock.deviation), formatted("%.1f", 1000 * clock.clock_deviation)});
  }
  report.results.push_back(std::move(clocks));
}

Table table_of_lag(const LagFit& fit, const std::vector<BallPlace>& places,
                   const std::vector<BallRecording>& recordings) {
  Table table{.columns = {"time [s]", "true distance [m]", "speed [m/s]", "speed away [m/s]", "error along [m]",
                          "error of elevation [rad]", "error of bearing [rad]"},
              .names = {},
              .rows = {}};
  for (const BallRecording& recording : recordings) table.names.push_back(recording.name);
  for (const LagImage& image : fit.images) {
    const BallPlace& place = places[image.place];
    table.rows.push_back(
        {.recording = image.recording,
         .values = {place.at, place.distance, place.speed(), place.away, image.along, image.elevation, image.bearing}});
  }
  return table;
}

void add_latency_notes(const LagFit& fit, const std::optional<Figure>& publish, const Figure& total, Report& report) {
  report.notes.push_back(
      formatted("left out: %zu percepts of slow or near balls, %zu of balls that were touched, %zu "
                "whose clock was compared by the ball itself",
                fit.slow, fit.bent, fit.by_ball));
  if (!publish)
    report.notes.emplace_back(
        "the time until the writing is not known, and counted as 0: a simulated game, or messages with their capture "
        "time");
  report.notes.emplace_back(
      "the error of a clock is contained in the interval: a late clock and a late percept look the same");
  const auto ticks = static_cast<double>(sim::ticks(static_cast<float>(std::max(0., total.value))));
  report.notes.push_back(formatted("the simulator rounds latencies to ticks of 1/30 s: %.3f s is played as %.3f s",
                                   total.value, ticks / double(sim::kTicksPerSecond)));
}

}  // namespace

Report fit_latency(const BallPlaces& places, const sim::Models& base) {
  Report report{.name = "latency", .title = "How old the robots' view of the ball is"};
  const ImageFacts facts = image_facts(base);
  const sim::perception::Noise& noise = base.perception.noise;
  const ImageNoise usual{.tilt = noise.tilt, .tilt_walking = noise.tilt_walking, .roll = noise.roll};
  const LagFit percept = fit_lag(places.percepts, places.recordings, facts, usual);
  const LagFit belief = fit_lag(places.beliefs, places.recordings, facts, usual);
  const auto publish = publish_figure(places.recordings);
  if (!percept.known) {
    report.kept.push_back("camera.latency: " + reason_of_lag(places, percept));
    report.needs.push_back(
        need_of("camera.latency", "passes of rolling balls", percept.passes.size(), kLagPassesWanted, kLatencyAdvice));
  } else {
    const Figure of_percept = lag_figure("latency.percept", percept, places.recordings);
    const Figure total = total_figure(of_percept, publish, report);
    report.figures = {total, of_percept};
    report.needs.push_back(need_of(total, kWantedLatency, kLatencyAdvice));
    report.pictures.push_back(latency_picture(percept, places.percepts, base.perception.camera.latency));
    report.tables.emplace_back("latency", table_of_lag(percept, places.percepts, places.recordings));
    report.scores.emplace_back("error_along", percept.error);
    report.scores.emplace_back("error_along_uncorrected", percept.uncorrected);
    add_results(percept, belief, report);
    add_latency_notes(percept, publish, total, report);
  }
  if (publish) report.figures.push_back(*publish);
  if (belief.known) report.figures.push_back(lag_figure("latency.belief", belief, places.recordings));
  return report;
}

Report fit_latency(const Evidence& evidence, const sim::Models& base) {
  return fit_latency(read_ball_places(evidence), base);
}

}  // namespace robot::fit
