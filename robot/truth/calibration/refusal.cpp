#include "robot/truth/calibration/refusal.h"

#include <Eigen/Eigenvalues>
#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <limits>
#include <set>

#include "robot/core/text.h"
#include "robot/truth/calibration/least_squares.h"

namespace robot::truth {
namespace {

constexpr std::size_t kFewestLandmarks = 4;
constexpr std::size_t kClicksPerOutlier = 5;  // more wrong clicks are no accident
constexpr double kLeastSpread = 0.15;         // [m] deviation of the landmarks from a line
constexpr double kSameSpot = 5;               // [px] a click this near to another landmark belongs to that one
constexpr double kBeyondChance = 3;           // deviations of a normal distribution
constexpr double kScaleDeviations = 3;        // of the prior, that a depth scale may be away from 1
constexpr std::size_t kMostNamed = 40;        // letters of a wrong name that a sentence repeats

const char* half_of(double x, const Camera& camera) {
  return x < camera.intrinsics.width / 2. ? "left half of the picture" : "right half of the picture";
}

/// Returns the half of the picture with fewer clicks.
const char* emptier_half(const std::vector<Click>& clicks, const Camera& camera) {
  const auto left = std::count_if(clicks.begin(), clicks.end(),
                                  [&](const Click& click) { return click.x < camera.intrinsics.width / 2.; });
  const bool left_is_emptier = 2 * left <= static_cast<std::ptrdiff_t>(clicks.size());
  return half_of(left_is_emptier ? 0 : camera.intrinsics.width, camera);
}

Result<void> check_click(const std::vector<Landmark>& landmarks, const Click& click, const Camera& camera) {
  const std::string name = printable(click.landmark, kMostNamed);
  if (!find_landmark(landmarks, click.landmark))
    return Error{formatted("clicks: the field has no landmark '%s'", name.c_str())};
  const Intrinsics& picture = camera.intrinsics;
  if (!(click.x >= 0 && click.x <= picture.width && click.y >= 0 && click.y <= picture.height))
    return Error{formatted("clicks: '%s' must be in the picture of %d x %d px, got (%g, %g)", name.c_str(),
                           picture.width, picture.height, click.x, click.y)};
  if (!camera.ray({click.x, click.y}))
    return Error{
        formatted("clicks: '%s' is at (%g, %g), where the lens shows nothing", name.c_str(), click.x, click.y)};
  return {};
}

/// Returns the deviation [m] of the clicked landmarks from the line that fits them best.
double spread_of(const std::vector<Landmark>& landmarks, const std::vector<Click>& clicks) {
  Eigen::Vector2d sum = Eigen::Vector2d::Zero();
  Eigen::Matrix2d squares = Eigen::Matrix2d::Zero();
  for (const Click& click : clicks) {
    const Eigen::Vector2d place = find_landmark(landmarks, click.landmark)->position.head<2>();
    sum += place;
    squares += place * place.transpose();
  }
  const auto count = static_cast<double>(clicks.size());
  const Eigen::Matrix2d covariance = squares / count - sum * sum.transpose() / (count * count);
  return std::sqrt(std::max(0., Eigen::SelfAdjointEigenSolver<Eigen::Matrix2d>(covariance).eigenvalues()[0]));
}

/// A judgement in progress.
struct Judgement {
  const Calibration& calibration;
  const Fit& fit;
  const std::vector<Landmark>& landmarks;
  const std::vector<Sighting>& sightings;
  const CalibrationOptions& options;

  /// Returns the landmark that a click shows, if it is another one than the person chose.
  const Landmark* meant_by(const ClickResidual& residual) const {
    const Landmark* nearest = nullptr;
    double least = kSameSpot * options.click_deviation;
    for (const Landmark& landmark : landmarks) {
      const double miss = miss_of(fit.view, {landmark.position, {residual.click.x, residual.click.y}, 1});
      if (miss < least) nearest = &landmark, least = miss;
    }
    return nearest && nearest->name != residual.click.landmark ? nearest : nullptr;
  }

  /// Returns the landmark in the picture whose click would make the robots' error least.
  const Landmark* most_helpful() const {
    const Landmark* best = nullptr;
    double least = std::numeric_limits<double>::infinity();
    for (const Landmark& landmark : landmarks) {
      if (is_clicked(landmark) || !fit.view.camera.shows(fit.view.seen(landmark.position))) continue;
      const double error = error_with(landmark);
      if (error < least) best = &landmark, least = error;
    }
    return best;
  }

  bool is_clicked(const Landmark& landmark) const {
    return std::any_of(calibration.residuals.begin(), calibration.residuals.end(),
                       [&](const ClickResidual& residual) { return residual.click.landmark == landmark.name; });
  }

  /// Returns the mean variance of the grid's places after a click of one more landmark.
  double error_with(const Landmark& landmark) const {
    const Residuals pixel = [&](const Eigen::VectorXd& step) -> Eigen::VectorXd {
      const View moved = fit.view.moved(step);
      return moved.camera.pixel(moved.seen(landmark.position)) / options.click_deviation;
    };
    const Eigen::MatrixXd slopes = slopes_at(pixel, Eigen::VectorXd::Zero(kViewParameters));
    const Eigen::Matrix2d innovation = slopes * fit.covariance * slopes.transpose() + Eigen::Matrix2d::Identity();
    const ViewCovariance gain = fit.covariance * slopes.transpose() * innovation.inverse() * slopes * fit.covariance;
    double sum = 0;
    for (const ErrorAt& at : calibration.ball.grid) {
      const Eigen::Vector3d place(at.x, at.y, options.ball_radius);
      const auto left = place_covariance(fit.view, fit.covariance - gain, place, Measurement::bearing);
      sum += left ? left->trace() : 0;
    }
    return sum;
  }

  std::string advice() const {
    const Landmark* landmark = most_helpful();
    if (!landmark) return "no other landmark is in the picture, so move or turn the sensor";
    const double x = fit.view.camera.pixel(fit.view.seen(landmark->position)).x();
    return formatted("click '%s' in the %s", landmark->name.c_str(), half_of(x, fit.view.camera));
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
        "sizes of "
        "the field",
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
        "sizes of "
        "the field and the lens",
        std::sqrt(squares / count), worst().click.landmark.c_str(), worst().pixels);
  }

  std::string scale_beyond_prior() const {
    const double off = std::abs(calibration.pose.depth_scale - 1),
                 most = kScaleDeviations * options.depth_scale_deviation;
    if (off <= most) return {};
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
    return formatted("the expected error is %.0f cm (p95), at most %.0f cm are useful: ", 100 * calibration.robots.p95,
                     100 * options.largest_error) +
           advice();
  }
};

}  // namespace

Result<void> check_clicks(const std::vector<Landmark>& landmarks, const std::vector<Click>& clicks,
                          const Camera& camera, const CalibrationOptions& options) {
  if (!(options.click_deviation > 0) || !(options.depth_scale_deviation >= 0))
    return Error{"calibration: the deviations of clicks and of the depth scale must be positive"};
  std::set<std::string> names;
  for (const Click& click : clicks) {
    if (auto checked = check_click(landmarks, click, camera); !checked) return checked;
    if (!names.insert(click.landmark).second)
      return Error{formatted("clicks: '%s' is clicked twice", click.landmark.c_str())};
  }
  if (clicks.size() < kFewestLandmarks)
    return Error{formatted("expected clicks of at least %zu landmarks, got %zu: click a landmark in the %s",
                           kFewestLandmarks, clicks.size(), emptier_half(clicks, camera))};
  if (const double spread = spread_of(landmarks, clicks); spread < kLeastSpread)
    return Error{
        formatted("all clicked landmarks are within %.2f m of one line: click a landmark away from this line", spread)};
  return {};
}

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
