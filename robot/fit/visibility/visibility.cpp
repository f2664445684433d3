#include "robot/fit/visibility/visibility.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "robot/core/text.h"
#include "robot/fit/visibility/detection.h"
#include "robot/fit/visibility/logistic.h"
#include "robot/fit/visibility/scoring.h"

namespace robot::fit {
namespace {

constexpr std::size_t kOfEach = 10;  // passes with a hit and passes with a miss, for each weight
constexpr double kBin = 0.5;         // [m] of the picture
constexpr double kEnoughShare = 0.03, kEnoughRange = 0.3;
constexpr std::size_t kCurvePoints = 120;

struct WeightName {
  const char* name;
  const char* unit;
};
constexpr std::array<WeightName, Logistic::kFeatures> kWeights{{{"constant", ""},
                                                                {"distance", "1/m"},
                                                                {"distance_squared", "1/m²"},
                                                                {"bearing", "1/rad"},
                                                                {"bearing_squared", "1/rad²"},
                                                                {"head_speed", "s/rad"},
                                                                {"hidden", ""}}};

constexpr const char* kSightAdvice =
    "play with balls at all distances up to the end of the range, in front of robots that look at them";

/// Passes with a seen ball and with a missed one.
struct PassCount {
  std::size_t hits = 0, misses = 0;
};

PassCount count_passes(const std::vector<Sight>& sights, const std::vector<Group>& passes, bool only_hidden) {
  PassCount count;
  for (const Group& pass : passes) {
    const auto any = [&](bool seen) {
      return std::ranges::any_of(
          pass, [&](std::size_t i) { return sights[i].seen == seen && (sights[i].hidden || !only_hidden); });
    };
    count.hits += any(true), count.misses += any(false);
  }
  return count;
}

Domain distances_in(const std::vector<Sight>& sights) {
  const auto [nearest, farthest] = std::ranges::minmax_element(sights, {}, &Sight::distance);
  return {.quantity = "true distance", .unit = "m", .from = nearest->distance, .to = farthest->distance};
}

/// Adds the weights, and returns the model if it can be fitted.
bool add_logistic(const Sights& sights, const std::vector<Group>& passes, Logistic& fit, Report& report) {
  const PassCount all = count_passes(sights.sights, passes, false);
  const std::size_t enough = kOfEach * Logistic::kFeatures;
  if (std::min(all.hits, all.misses) < enough) {
    report.kept.push_back(
        formatted("visibility: expected at least %zu passes with a seen ball and %zu with a missed one for the "
                  "logistic model, got %zu "
                  "and %zu",
                  enough, enough, all.hits, all.misses));
    return false;
  }
  fit = fit_logistic(sights.sights, all_of(sights.sights.size()));
  const Logistic::Features around = deviations_of(fit, sights.sights, passes);
  const PassCount hidden = count_passes(sights.sights, passes, true);
  for (std::size_t k = 0; k < Logistic::kFeatures; ++k) {
    const std::string name = std::string("visibility.") + kWeights[k].name;
    if (k + 1 == Logistic::kFeatures && std::min(hidden.hits, hidden.misses) < kOfEach) {
      report.kept.push_back(
          formatted("%s: expected at least %zu passes with a hidden ball that is seen and %zu with one that is missed, "
                    "got %zu and %zu",
                    name.c_str(), kOfEach, kOfEach, hidden.hits, hidden.misses));
      continue;
    }
    const double half = two_sided(passes.size() - 1) * around[k];
    report.figures.push_back({.name = name,
                              .unit = kWeights[k].unit,
                              .value = fit.weights[k],
                              .low = fit.weights[k] - half,
                              .high = fit.weights[k] + half,
                              .events = passes.size(),
                              .kind = "passes",
                              .recordings = sights.recordings,
                              .domain = distances_in(sights.sights)});
  }
  return true;
}

/// The free balls of a range of distances.
struct SharePoint {
  double distance = 0, seen = 0, predicted = 0, images = 0;  // sums, then means
};

std::vector<SharePoint> shares_over_distance(const std::vector<Sight>& sights, const Logistic* logistic) {
  std::vector<SharePoint> bins;
  for (const Sight& sight : sights) {
    if (sight.hidden) continue;
    const auto index = static_cast<std::size_t>(sight.distance / kBin);
    if (index >= bins.size()) bins.resize(index + 1);
    SharePoint& bin = bins[index];
    bin.distance += sight.distance, bin.seen += sight.seen ? 1 : 0, ++bin.images;
    if (logistic) bin.predicted += logistic->probability(features_of(sight));
  }
  std::erase_if(bins, [](const SharePoint& bin) { return bin.images == 0; });
  for (SharePoint& bin : bins) bin.distance /= bin.images, bin.seen /= bin.images, bin.predicted /= bin.images;
  return bins;
}

Mark line_along(const DetectionCurve& curve, double most, Mark::Role role, const char* label) {
  Mark mark{.shape = Mark::Shape::line, .role = role, .label = label};
  for (std::size_t i = 0; i <= kCurvePoints; ++i) {
    mark.x.push_back(most * static_cast<double>(i) / kCurvePoints);
    mark.y.push_back(curve.probability(mark.x.back()));
  }
  return mark;
}

Picture share_picture(const Sights& sights, const Logistic* logistic, const DetectionFit& detection,
                      const DetectionCurve& standard) {
  const std::vector<SharePoint> bins = shares_over_distance(sights.sights, logistic);
  Mark seen{.shape = Mark::Shape::dots, .role = Mark::Role::truth, .label = "share seen of free balls in view"};
  Mark model{.shape = Mark::Shape::line, .role = Mark::Role::robot, .label = "logistic model, mean of the same images"};
  for (const SharePoint& bin : bins) {
    seen.x.push_back(bin.distance), seen.y.push_back(bin.seen);
    if (logistic) model.x.push_back(bin.distance), model.y.push_back(bin.predicted);
  }
  const double most = std::ceil(distances_in(sights.sights).to);
  Picture picture{.title = "Balls seen over their distance",
                  .x_label = "true distance [m]",
                  .y_label = "share of images",
                  .axes = {.left = 0, .right = most, .bottom = 0, .top = 1}};
  picture.marks.push_back(line_along(standard, most, Mark::Role::other, "default of the simulator"));
  if (!detection.figures.empty())
    picture.marks.push_back(line_along(detection.curve, most, Mark::Role::fitted, "the simulator's model, fitted"));
  if (logistic) picture.marks.push_back(std::move(model));
  picture.marks.push_back(std::move(seen));
  return picture;
}

Mark reliability_dots(const Sights& sights, const SightScores& scores, SightModel which, Mark::Role role) {
  const auto index = static_cast<std::size_t>(which);
  Mark mark{.shape = Mark::Shape::dots, .role = role, .label = kSightModels[index]};
  for (const ReliabilityBin& bin : reliability(sights.sights, scores.models[index].probabilities)) {
    mark.x.push_back(bin.predicted);
    mark.y.push_back(bin.observed);
  }
  return mark;
}

Picture reliability_picture(const Sights& sights, const SightScores& scores, SightModel main) {
  Mark counts{
      .shape = Mark::Shape::bars, .role = Mark::Role::truth, .label = "share of all images in a bin", .width = 0.1};
  const auto all = static_cast<double>(sights.sights.size());
  for (const ReliabilityBin& bin :
       reliability(sights.sights, scores.models[static_cast<std::size_t>(main)].probabilities)) {
    counts.x.push_back(std::min(0.9, std::floor(bin.predicted * 10) / 10));
    counts.y.push_back(static_cast<double>(bin.images) / all);
  }
  Picture picture{.title = "Reliability on images held out",
                  .x_label = "predicted probability",
                  .y_label = "share seen",
                  .axes = {.left = 0, .right = 1, .bottom = 0, .top = 1}};
  picture.marks = {std::move(counts),
                   {.shape = Mark::Shape::line, .role = Mark::Role::other, .label = "ideal", .x = {0, 1}, .y = {0, 1}},
                   reliability_dots(sights, scores, SightModel::detection, Mark::Role::robot),
                   reliability_dots(sights, scores, SightModel::logistic, Mark::Role::fitted)};
  return picture;
}

void add_scores(const SightScores& scores, Report& report) {
  static constexpr std::array<const char*, 4> kKeys{"constant", "default", "detection", "logistic"};
  Results results{.title = "Predictions of images held out: " + scores.parts, .head = {"model", "log-loss", "Brier"}};
  for (std::size_t k = 0; k < scores.models.size(); ++k) {
    const SightScore& model = scores.models[k];
    results.rows.push_back({kSightModels[k], formatted("%.4f", model.log_loss), formatted("%.4f", model.brier)});
    report.scores.emplace_back(std::string("log_loss_") + kKeys[k], model.log_loss);
    report.scores.emplace_back(std::string("brier_") + kKeys[k], model.brier);
  }
  report.results.push_back(std::move(results));
}

Table table_of(const Sights& sights) {
  Table table{.columns = {"time [s]", "true distance [m]", "bearing from the axis [rad]", "speed of the head [rad/s]",
                          "hidden", "seen"},
              .names = sights.recordings,
              .rows = {}};
  for (const Sight& sight : sights.sights)
    table.rows.push_back({.recording = sight.recording,
                          .values = {sight.at, sight.distance, sight.off_axis, sight.head_speed, sight.hidden ? 1. : 0.,
                                     sight.seen ? 1. : 0.}});
  return table;
}

void add_needs(std::size_t passes, Report& report) {
  for (const char* name : {"near", "far", "near_range"}) {
    const std::string whole = std::string("ball_detection.") + name;
    const Figure* const figure = report.figure(whole);
    if (!figure)
      report.needs.push_back(need_of(whole, "passes", passes, std::max<std::size_t>(200, 2 * passes), kSightAdvice));
    else
      report.needs.push_back(need_of(*figure, figure->unit == "m" ? kEnoughRange : kEnoughShare, kSightAdvice));
  }
}

Report empty_report() { return {.name = "visibility", .title = "Which balls the robots see"}; }

}  // namespace

Report visibility_of(const Sights& sights, const sim::Models& base) {
  Report report = empty_report();
  const std::vector<Group> passes = passes_of(sights.sights);
  if (passes.empty()) {
    report.kept.push_back(formatted(
        "visibility: expected images with the ball in view, got none (%zu with a ball too near to the border)",
        sights.near_border));
    add_needs(0, report);
    return report;
  }
  const DetectionCurve standard = curve_of(base.perception.ball);
  DetectionFit detection = fit_detection(sights, passes, standard);
  report.figures = detection.figures;
  report.kept = detection.kept;
  Logistic logistic;
  const bool is_fitted = add_logistic(sights, passes, logistic, report);
  report.pictures.push_back(share_picture(sights, is_fitted ? &logistic : nullptr, detection, standard));
  if (is_fitted) {
    const SightScores scores = scores_of(sights, passes, standard);
    add_scores(scores, report);
    report.pictures.push_back(reliability_picture(sights, scores, SightModel::logistic));
  }
  const auto hidden = static_cast<std::size_t>(std::ranges::count(sights.sights, true, &Sight::hidden));
  report.notes.push_back(formatted("Images with the ball in view: %zu in %zu passes, in %zu of them a robot hides it.",
                                   sights.sights.size(), passes.size(), hidden));
  report.notes.push_back(formatted(
      "Not used: %zu images with the ball near their border and %zu with a robot near the line of sight, within "
      "three errors of the truth.",
      sights.near_border, sights.unsure));
  report.tables.emplace_back("visibility", table_of(sights));
  add_needs(passes.size(), report);
  return report;
}

Report fit_visibility(const Evidence& evidence, const sim::Models& base) {
  return fit_visibility(read_looks(evidence, base), base);
}

Report fit_visibility(const Looks& looks, const sim::Models& base) {
  if (looks.looks.empty()) {
    Report report = empty_report();
    report.kept.push_back("visibility: " + reason_without(looks));
    add_needs(0, report);
    return report;
  }
  Report report = visibility_of(sights_of(looks, base), base);
  report.notes.push_back(left_out(looks));
  return report;
}

}  // namespace robot::fit
