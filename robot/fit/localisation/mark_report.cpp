#include "robot/fit/localisation/mark_report.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "robot/core/text.h"
#include "robot/fit/localisation/mark_fit.h"
#include "robot/fit/localisation/odometry.h"
#include "robot/fit/localisation/odometry_fit.h"

namespace robot::fit {
namespace {

constexpr const char* kMarkNames[] = {"localisation.mark_deviation", "localisation.mark_deviation_heading"};
constexpr const char* kMarkUnits[] = {"m", "rad"};
constexpr double kWidestMark[] = {0.04, 0.05};
constexpr const char* kMarkAdvice =
    "record pose, odometry and motion_status of more robots that play alone or in games";
constexpr std::size_t kEnoughBlocks = 20, kEnoughWalks = 40;

/// Sets the fitted events of the report in the models.
void take_events(const Report& report, sim::perception::Localisation& model) {
  const auto take = [&](const char* name, float& value) {
    if (const Figure* const figure = report.figure(name)) value = static_cast<float>(figure->value);
  };
  take("localisation.start_deviation", model.start_deviation);
  take("localisation.start_deviation_heading", model.start_deviation_heading);
  take("localisation.fall_deviation", model.fall_deviation);
  take("localisation.fall_deviation_heading", model.fall_deviation_heading);
}

/// Sets the fitted odometry in the models. Returns its errors.
std::vector<UncertainFigure> take_odometry(const Drift& drift, const OdometryFit& fit,
                                           sim::perception::Localisation& model) {
  using sim::perception::Localisation;
  constexpr float Localisation::*kFigures[] = {&Localisation::translation_noise, &Localisation::rotation_noise,
                                               &Localisation::rotation_per_metre};
  std::vector<UncertainFigure> uncertain;
  const std::vector<RootInterval> intervals = noise_intervals(drift, fit);
  for (std::size_t i = 0; i < intervals.size(); ++i) {
    if (!std::isfinite(intervals[i].high)) continue;
    model.*kFigures[i] = static_cast<float>(intervals[i].value);
    uncertain.push_back({.figure = kFigures[i], .deviation = (intervals[i].high - intervals[i].low) / 2 / 1.96});
  }
  if (std::isfinite(fit.model.bias)) model.bias = static_cast<float>(fit.model.bias);
  return uncertain;
}

std::vector<MarkWalk> with_scales(const MarkEvidence& evidence, const OdometryFit& fit) {
  std::vector<MarkWalk> walks = evidence.walks;
  for (std::size_t i = 0; i < walks.size(); ++i) {
    const std::size_t recording = evidence.drift_of[i];
    if (fit.walking[recording].is_known()) walks[i].scale = static_cast<float>(fit.walking[recording].value);
    if (fit.turning[recording].is_known()) walks[i].turn_scale = static_cast<float>(fit.turning[recording].value);
  }
  return walks;
}

void keep_marks(const std::string& reason, std::size_t blocks, Report& report) {
  report.kept.push_back("localisation.mark_deviation and its heading: " + reason);
  report.needs.push_back(need_of(kMarkNames[0], "half minutes", blocks, kEnoughBlocks, kMarkAdvice));
}

void add_mark_figure(std::size_t which, const RootInterval& interval, const std::string& kept, const MarkFit& fit,
                     const MarkEvidence& evidence, Report& report) {
  if (!kept.empty()) {
    report.kept.push_back(std::string(kMarkNames[which]) + ": " + kept);
    report.needs.push_back(need_of(kMarkNames[which], "half minutes", 0, kEnoughBlocks, kMarkAdvice));
    return;
  }
  const double error = std::sqrt(which == 0 ? fit.recorded.place : fit.recorded.heading);
  report.figures.push_back({.name = kMarkNames[which],
                            .unit = kMarkUnits[which],
                            .value = interval.value,
                            .low = interval.low,
                            .high = interval.high,
                            .events = fit.blocks,
                            .kind = "half minutes",
                            .recordings = evidence.recordings,
                            .domain = {.quantity = "recorded error", .unit = kMarkUnits[which], .from = 0, .to = error},
                            .widest = kWidestMark[which]});
  report.needs.push_back(need_of(report.figures.back(), kWidestMark[which] / 2, kMarkAdvice));
}

void add_mark_picture(const MarkFit& fit, Report& report) {
  Picture picture{.title = "Errors of the believed place, recorded and as the simulator makes them on the same walks",
                  .x_label = "error of the place [m]",
                  .y_label = "share of the poses in 2 cm",
                  .axes = {},
                  .marks = {}};
  double top = 0;
  const auto add = [&](const MarkErrors& errors, Mark mark) {
    for (std::size_t i = 0; i < errors.histogram.size(); ++i) {
      mark.x.push_back((static_cast<double>(i) + (mark.shape == Mark::Shape::bars ? 0 : 0.5)) * kMarkBin);
      mark.y.push_back(errors.histogram[i]);
      top = std::max(top, errors.histogram[i]);
    }
    picture.marks.push_back(std::move(mark));
  };
  add(fit.recorded, {.shape = Mark::Shape::bars,
                     .role = Mark::Role::robot,
                     .label = "recorded",
                     .x = {},
                     .y = {},
                     .high = {},
                     .width = kMarkBin});
  add(fit.before, {.shape = Mark::Shape::line,
                   .role = Mark::Role::other,
                   .label = "simulated with the marks of the models so far",
                   .x = {},
                   .y = {},
                   .high = {}});
  add(fit.fitted, {.shape = Mark::Shape::line,
                   .role = Mark::Role::fitted,
                   .label = "simulated with the fitted marks",
                   .x = {},
                   .y = {},
                   .high = {}});
  picture.axes = {
      .left = 0, .right = kMarkBin * static_cast<double>(fit.recorded.histogram.size()), .bottom = 0, .top = 1.1 * top};
  report.pictures.push_back(std::move(picture));
}

void add_mark_results(const MarkFit& fit, Report& report) {
  const auto row = [](const std::string& name, const MarkErrors& errors) {
    return std::vector<std::string>{name, formatted("%.3f", std::sqrt(std::max(0., errors.place))),
                                    formatted("%.3f", std::sqrt(std::max(0., errors.heading)))};
  };
  report.results.push_back({.title = "Root mean square errors of settled poses, 5 s after a fall or an entrance",
                            .head = {"poses", "place [m]", "heading [rad]"},
                            .rows = {row("recorded, without the truth's errors", fit.recorded),
                                     row("simulated with the fitted marks", fit.fitted),
                                     row("simulated with the marks of the models so far", fit.before)}});
}

}  // namespace

void add_mark_walk(const WatchedMotion& motion, const std::vector<PoseError>& errors, const TruthNoise& noise,
                   MarkEvidence& evidence) {
  MarkWalk walk = mark_walk(motion, errors, noise);
  if (walk.moments.empty() || motion.odometry.empty()) return;
  evidence.drift_of.push_back(evidence.drift.recordings.size());
  evidence.recordings.push_back(motion.name);
  add_drift(motion, evidence.drift);
  evidence.walks.push_back(std::move(walk));
}

void add_marks(const MarkEvidence& evidence, const sim::Models& base, const sim::field::Field& field, Report& report) {
  const auto walked = static_cast<std::size_t>(std::ranges::count_if(
      evidence.drift.windows, [](const DriftWindow& window) { return window.way > 0 || window.turned > 0; }));
  if (walked < kEnoughWalks)
    return keep_marks(formatted("expected at least %zu windows of odometry beside the poses and motion_status, got %zu",
                                kEnoughWalks, walked),
                      0, report);
  const OdometryFit odometry = fit_drift(evidence.drift.windows, evidence.drift.recordings.size());
  sim::Models models = base;
  take_events(report, models.perception.localisation);
  const auto uncertain = take_odometry(evidence.drift, odometry, models.perception.localisation);
  const auto fit = fit_marks(with_scales(evidence, odometry), models, field, uncertain);
  if (!fit) return keep_marks(fit.error(), 0, report);
  add_mark_figure(0, fit->place, fit->place_kept, *fit, evidence, report);
  add_mark_figure(1, fit->heading, fit->heading_kept, *fit, evidence, report);
  add_mark_picture(*fit, report);
  add_mark_results(*fit, report);
  const auto blind = std::ranges::count_if(evidence.walks, [](const MarkWalk& walk) { return !walk.knows_head; });
  if (blind > 0)
    report.notes.push_back(
        formatted("%td recordings have no camera_top_matrix; for the marks their robots look ahead", blind));
  report.notes.push_back(formatted(
      "the marks are fitted with the field, the camera and the other figures of the models: mark_near %.2f, mark_range "
      "%.1f m, mark_interval %.1f s",
      static_cast<double>(base.perception.localisation.mark_near),
      static_cast<double>(base.perception.localisation.mark_range),
      static_cast<double>(base.perception.localisation.mark_interval)));
}

}  // namespace robot::fit
