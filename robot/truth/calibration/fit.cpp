#include "robot/truth/calibration/fit.h"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>

#include "robot/truth/calibration/least_squares.h"

namespace robot::truth {
namespace {

constexpr double kFar = 1e4;            // [px] miss of a landmark that the sensor cannot see
constexpr double kCauchy = 3;           // deviations from which a miss counts less than its square
constexpr double kKnownExactly = 1e-6;  // deviation in place of 0, which would divide by it
constexpr int kCarpetResiduals = 4, kPriorResiduals = 3;

Eigen::Vector2d error_of(const Projection& camera, const Eigen::Vector3d& seen, const Eigen::Vector2d& pixel) {
  if (!(seen.z() > 0.01)) return {kFar, 0};
  return camera.pixel(seen) - pixel;
}

/// Returns the vector whose square is Cauchy's loss of `error`.
Eigen::Vector2d softened(const Eigen::Vector2d& error) {
  const double square = error.squaredNorm();
  return square > 0
             ? Eigen::Vector2d(error * std::sqrt(kCauchy * kCauchy * std::log1p(square / (kCauchy * kCauchy)) / square))
             : error;
}

/// Returns the carpet at measured depths, as this view places it.
Eigen::Vector4d carpet_of(const View& view) {
  Eigen::Vector4d plane;
  plane << view.field_from_sensor.linear().row(2).transpose(),
      view.field_from_sensor.translation().z() / view.depth_scale;
  return plane;
}

Eigen::Vector3d prior_residuals(const View& view, const Prior& prior) {
  const auto scaled = [](double error, double deviation) { return error / std::max(deviation, kKnownExactly); };
  return {scaled(view.depth_scale - 1, prior.depth_scale_deviation),
          scaled(std::log(view.camera.intrinsics.focal_x / prior.camera.intrinsics.focal_x), prior.focal_deviation),
          scaled(view.camera.lens.k1 - prior.camera.lens.k1, prior.k1_deviation)};
}

/// The residuals of a fit, for any view.
struct Cost {
  const std::vector<Sighting>& sightings;
  const std::optional<Ground>& ground;
  const Prior& prior;
  Loss loss;

  Eigen::VectorXd operator()(const View& view) const {
    const auto count = 2 * static_cast<Eigen::Index>(sightings.size());
    Eigen::VectorXd residuals = Eigen::VectorXd::Zero(count + kCarpetResiduals + kPriorResiduals);
    const Eigen::Isometry3d sensor_from_field = view.field_from_sensor.inverse();
    Eigen::Index at = 0;
    for (const Sighting& sighting : sightings) {
      const Eigen::Vector2d error =
          error_of(view.camera, sensor_from_field * sighting.place, sighting.pixel) / sighting.deviation;
      residuals.segment<2>(at) = loss == Loss::cauchy ? softened(error) : error;
      at += 2;
    }
    if (ground) residuals.segment<kCarpetResiduals>(at) = ground->roots * carpet_of(view);
    residuals.tail<kPriorResiduals>() = prior_residuals(view, prior);
    return residuals;
  }
};

}  // namespace

double miss_of(const View& view, const Sighting& sighting) {
  return error_of(view.camera, view.seen(sighting.place), sighting.pixel).norm();
}

Fit fit_view(const View& start, const std::vector<Sighting>& sightings, const std::optional<Ground>& ground,
             const Prior& prior, Loss loss) {
  const Cost cost{sightings, ground, prior, loss};
  const auto around = [&cost](const View& view) {
    return [&cost, view](const Eigen::VectorXd& step) { return cost(view.moved(step)); };
  };
  const Eigen::VectorXd none = Eigen::VectorXd::Zero(kViewParameters);
  const View view = start.moved(minimise(around(start), none));
  // the covariance belongs to small steps from the result
  const Eigen::MatrixXd slopes = slopes_at(around(view), none);
  const ViewCovariance information = slopes.transpose() * slopes;
  return {view, information.inverse()};
}

}  // namespace robot::truth
