#include "robot/truth/calibration/advice.h"

#include <Eigen/LU>
#include <algorithm>
#include <limits>

#include "robot/core/text.h"
#include "robot/truth/calibration/least_squares.h"

namespace robot::truth {
namespace {

/// Returns the covariance of the fit after a click of one more landmark.
ViewCovariance covariance_with(const Landmark& landmark, const Fit& fit, double click_deviation) {
  const Residuals pixel = [&](const Eigen::VectorXd& step) -> Eigen::VectorXd {
    const View moved = fit.view.moved(step);
    return moved.camera.pixel(moved.seen(landmark.position)) / click_deviation;
  };
  const Eigen::MatrixXd slopes = slopes_at(pixel, ViewStep::Zero());
  const Eigen::Matrix2d innovation = slopes * fit.covariance * slopes.transpose() + Eigen::Matrix2d::Identity();
  return fit.covariance - fit.covariance * slopes.transpose() * innovation.inverse() * slopes * fit.covariance;
}

/// Returns the sum of the variances [m²] at the places of all landmarks that the picture shows.
double variance_at_landmarks(const View& view, const ViewCovariance& covariance,
                             const std::vector<Landmark>& landmarks) {
  double sum = 0;
  for (const Landmark& landmark : landmarks) {
    if (!view.camera.shows(view.seen(landmark.position))) continue;
    const auto error = place_covariance(view, covariance, landmark.position, MeasuredBy::bearing);
    sum += error ? error->trace() : 0;
  }
  return sum;
}

}  // namespace

const char* half_of(double x, const Projection& camera) {
  return x < camera.intrinsics.width / 2. ? "left half of the picture" : "right half of the picture";
}

std::string advice(const Fit& fit, const std::vector<Landmark>& landmarks, const std::vector<std::string>& clicked,
                   const CalibrationOptions& options) {
  const View& view = fit.view;
  const Landmark* best = nullptr;
  double least = std::numeric_limits<double>::infinity();
  for (const Landmark& landmark : landmarks) {
    const bool is_clicked = std::find(clicked.begin(), clicked.end(), landmark.name) != clicked.end();
    if (is_clicked || !view.camera.shows(view.seen(landmark.position))) continue;
    const double variance =
        variance_at_landmarks(view, covariance_with(landmark, fit, options.click_deviation), landmarks);
    if (variance < least) best = &landmark, least = variance;
  }
  if (!best) return "no other landmark is in the picture, so move or turn the sensor";
  const double x = view.camera.pixel(view.seen(best->position)).x();
  return formatted("click '%s' in the %s", best->name.c_str(), half_of(x, view.camera));
}

}  // namespace robot::truth
