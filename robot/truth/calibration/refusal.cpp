#include "robot/truth/calibration/refusal.h"

#include <algorithm>
#include <cmath>

#include "robot/core/text.h"
#include "robot/truth/calibration/advice.h"
#include "robot/truth/calibration/check_clicks.h"

namespace robot::truth {
namespace {

constexpr std::size_t kClicksPerOutlier = 5;  // more wrong clicks are no accident
constexpr double kSameSpot = 5;               // deviations of a click; so near to another landmark, it shows that one
constexpr double kBeyondChance = 3;           // deviations of a normal distribution
constexpr double kScaleDeviations = 3;        // of the prior, that a depth scale may be away from 1

/// A judgement in progress. Each function returns its reason to refuse, or an empty text.
struct Judgement {
  const Calibration& calibration;
  const Fit& fit;
  const std::vector<Landmark>& landmarks;
  const std::vector<Sighting>& sightings;
  const CalibrationOptions& options;

  /// Returns the landmark that a click shows, if it is another one than the person chose.
  const Landmark* meant_by(const ClickResidual& residual) const {
    const Landmark* nearest = nullptr;
    double least = kSameSpot * options.click_deviation;  // [px]
    for (const Landmark& landmark : landmarks) {
      const double miss = miss_of(fit.view, {landmark.position, {residual.click.x, residual.click.y}, 1});
      if (miss < least) nearest = &landmark, least = miss;
    }
    return nearest && nearest->name != residual.click.landmark ? nearest : nullptr;
  }

  const ClickResidual& worst() const {
    return *std::max_element(calibration.residuals.begin(), calibration.residuals.end(),
                             [](const auto& a, const auto& b) { return a.pixels < b.pixels; });
  }

  std::string wrong_landmark() const {
    for (const ClickResidual& residual : calibration.residuals)
      if (const Landmark* meant = residual.outlier ? meant_by(residual) : nullptr)
        return formatted("the click of '%s' shows '%s': click it again", residual.click.landmark.c_str(),
                         meant->name.c_str());
    return {};
  }

  std::string too_many_outliers() const {
    const auto outliers = static_cast<std::size_t>(std::count_if(
        calibration.residuals.begin(), calibration.residuals.end(), [](const auto& it) { return it.outlier; }));
    const std::size_t all = calibration.residuals.size();
    if (all - outliers >= kFewestLandmarks && kClicksPerOutlier * outliers <= all) return {};
    return formatted(
        "%zu of %zu clicks do not fit the others, and the worst is '%s' by %.0f px: click it again, and check the "
        "sizes of the field",
        outliers, all, worst().click.landmark.c_str(), worst().pixels);
  }

  /// A sum of squares of normal numbers is compared by Wilson and Hilferty's approximation.
  std::string residuals_beyond_chance() const {
    double squares = 0, count = 0;
    for (std::size_t i = 0; i < sightings.size(); ++i)
      if (!calibration.residuals[i].outlier)
        squares += std::pow(calibration.residuals[i].pixels / sightings[i].deviation, 2), count += 2;
    const double variance = 2 / (9 * count);
    if (std::cbrt(squares / count) <= 1 - variance + kBeyondChance * std::sqrt(variance)) return {};
    return formatted(
        "the clicks miss by %.1f deviations of a click, expected about 1: click '%s' again (%.1f px), and check the "
        "lens "
        "and the sizes of the field",
        std::sqrt(squares / count), worst().click.landmark.c_str(), worst().pixels);
  }

  std::string scale_beyond_prior() const {
    const double most = kScaleDeviations * options.depth_scale_deviation;
    if (std::abs(calibration.pose.depth_scale - 1) <= most) return {};
    return formatted(
        "the depth scale is %.3f, expected 1 ± %.3f: check the sizes of the field and the focal length of the sensor",
        calibration.pose.depth_scale, most);
  }

  std::string sees_nothing() const {
    if (!calibration.robots.grid.empty()) return {};
    return formatted("the sensor sees no part of the field within %.0f m: turn it towards the field", kFarthestDepth);
  }

  std::string too_uncertain() const {
    if (calibration.robots.p95 <= options.largest_error) return {};
    std::vector<std::string> clicked;
    for (const ClickResidual& residual : calibration.residuals) clicked.push_back(residual.click.landmark);
    return formatted("the expected error is %.0f cm (p95), at most %.0f cm are useful: %s",
                     100 * calibration.robots.p95, 100 * options.largest_error,
                     advice(fit, landmarks, clicked, options).c_str());
  }
};

}  // namespace

std::string refusal_of(const Calibration& calibration, const Fit& fit, const std::vector<Landmark>& landmarks,
                       const std::vector<Sighting>& sightings, const CalibrationOptions& options) {
  const Judgement judgement{calibration, fit, landmarks, sightings, options};
  for (const auto reason :
       {&Judgement::wrong_landmark, &Judgement::too_many_outliers, &Judgement::residuals_beyond_chance,
        &Judgement::scale_beyond_prior, &Judgement::sees_nothing, &Judgement::too_uncertain})
    if (std::string sentence = (judgement.*reason)(); !sentence.empty()) return sentence;
  return {};
}

}  // namespace robot::truth
