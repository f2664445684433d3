#include "robot/truth/calibration/expected_error.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

#include "robot/truth/calibration/least_squares.h"

namespace robot::truth {
namespace {

constexpr double kGrid = 0.5;   // [m]
constexpr int kDirections = 8;  // of half a circle

/// A distance of two normal coordinates: in each direction it has a Rayleigh distribution, whose parameter is the deviation
/// in that direction. So all places of a field together are a mixture of Rayleigh distributions.
class DistanceMixture {
 public:
  /// Adds a place and returns the mean of its distance.
  double add(const Eigen::Matrix2d& covariance) {
    double sum = 0;
    for (int i = 0; i < kDirections; ++i) {
      const double angle = M_PI * i / kDirections;
      const Eigen::Vector2d direction(std::cos(angle), std::sin(angle));
      variances_.push_back(direction.dot(covariance * direction));
      sum += std::sqrt(M_PI / 2 * variances_.back());
    }
    return sum / kDirections;
  }

  /// Returns the distance that the share `part` of all errors stays below.
  double quantile(double part) const {
    double least = 0, most = 10 * std::sqrt(*std::max_element(variances_.begin(), variances_.end()));
    for (int i = 0; i < 50; ++i) {
      const double middle = (least + most) / 2;
      (share_below(middle) < part ? least : most) = middle;
    }
    return most;
  }

 private:
  double share_below(double distance) const {
    double sum = 0;
    for (const double variance : variances_)
      if (variance > 0) sum += std::exp(-distance * distance / (2 * variance));
    return 1 - sum / static_cast<double>(variances_.size());
  }

  std::vector<double> variances_;  // [m²]
};

bool sees(const View& view, const Eigen::Vector3d& point, MeasuredBy measurement) {
  const Eigen::Vector3d seen = view.seen(point);
  return view.camera.shows(seen) && (measurement == MeasuredBy::bearing || seen.z() <= kFarthestDepth);
}

}  // namespace

std::optional<Eigen::Matrix2d> place_covariance(const View& view, const ViewCovariance& covariance,
                                                const Eigen::Vector3d& point, MeasuredBy measurement) {
  const Eigen::Vector3d seen = view.seen(point);
  const Eigen::Vector2d pixel = view.camera.pixel(seen);
  const Residuals place = [&](const Eigen::VectorXd& step) -> Eigen::VectorXd {
    const View moved = view.moved(step);
    const auto measured = measurement == MeasuredBy::depth ? moved.point(pixel, seen.z() / view.depth_scale)
                                                           : moved.point_at_height(pixel, point.z());
    return measured.value_or(Eigen::Vector3d::Constant(std::numeric_limits<double>::infinity())).head<2>();
  };
  const Eigen::Matrix<double, 2, kViewParameters> slopes = slopes_at(place, ViewStep::Zero());
  const Eigen::Matrix2d error = slopes * covariance * slopes.transpose();
  if (!error.allFinite()) return std::nullopt;
  return error;
}

ExpectedError expected_error(const View& view, const ViewCovariance& covariance, const Eigen::Vector2d& reach,
                             MeasuredBy measurement, double height) {
  ExpectedError error;
  DistanceMixture distances;
  const auto steps = [](double length) { return static_cast<int>(std::floor(length / kGrid)); };
  for (int i = -steps(reach.x()); i <= steps(reach.x()); ++i)
    for (int j = -steps(reach.y()); j <= steps(reach.y()); ++j) {
      const Eigen::Vector3d point(i * kGrid, j * kGrid, height);
      if (!sees(view, point, measurement)) continue;
      const auto spread = place_covariance(view, covariance, point, measurement);
      if (spread) error.grid.push_back({point.x(), point.y(), distances.add(*spread)});
    }
  if (error.grid.empty()) return error;
  error.mean = std::accumulate(error.grid.begin(), error.grid.end(), 0.,
                               [](double sum, const ErrorAt& at) { return sum + at.metres; }) /
               static_cast<double>(error.grid.size());
  error.p95 = distances.quantile(0.95);
  return error;
}

}  // namespace robot::truth
