#include "robot/truth/tags/ball_colour.h"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <vector>

namespace robot::truth::tags {
namespace {

constexpr double kLeastVisible = 0.4;     // share of the ball's disc
constexpr double kMostVisible = 1.6;      // likewise; blur and the pixels of the edge make small balls larger
constexpr double kMostWidth = 1.5;        // largest second moment / that of a disc
constexpr double kMiddleDeviation = 0.3;  // [px] of a spot's middle
constexpr std::size_t kFewestPixels = 6;

/// A spot as a bundle of rays.
struct Bundle {
  Eigen::Vector3d middle = Eigen::Vector3d::Zero();  // unit vector [field]
  double solid_angle = 0;                            // [sr]
  double widest = 0;                                 // [rad²] largest second moment
};

/// Returns nothing if the lens does not show a pixel of the spot.
std::optional<Bundle> bundle_of(const Spot& spot, const Camera& camera) {
  Bundle bundle;
  Eigen::Matrix3d moments = Eigen::Matrix3d::Zero();
  const Intrinsics& intrinsics = camera.projection.intrinsics;
  for (const Eigen::Vector2d& pixel : spot) {
    const auto ray = camera.projection.ray(pixel);
    if (!ray) return std::nullopt;
    const double slant = 1 / ray->norm();  // cosine of the angle to the optical axis
    const Eigen::Vector3d way = camera.field_from_camera.linear() * (slant * *ray);
    bundle.solid_angle += slant * slant * slant / (intrinsics.focal_x * intrinsics.focal_y);
    bundle.middle += way;
    moments += way * way.transpose();
  }
  const auto count = static_cast<double>(spot.size());
  const Eigen::Vector3d mean = bundle.middle / count;
  bundle.widest =
      Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d>(moments / count - mean * mean.transpose(), Eigen::EigenvaluesOnly)
          .eigenvalues()[2];
  bundle.middle.normalize();
  return bundle;
}

/// A spot that may be the ball.
struct Candidate {
  SeenBall ball;
  double visible = 0;  // share of the disc
};

/// Returns the covariance of a place on the plane [m²]: `angle` [rad] across the ray, which hits the plane at a slant.
Eigen::Matrix2d plane_covariance(const Eigen::Vector3d& way, double distance, double angle) {
  const double across = std::pow(distance * angle, 2), along = across / (way.z() * way.z());
  const Eigen::Vector2d flat = way.head<2>();
  if (flat.norm() < 1e-6) return across * Eigen::Matrix2d::Identity();
  const Eigen::Vector2d forward = flat.normalized();
  return across * Eigen::Matrix2d::Identity() + (along - across) * forward * forward.transpose();
}

std::optional<Candidate> candidate_of(const Spot& spot, const Camera& camera, double radius) {
  const auto bundle = bundle_of(spot, camera);
  if (!bundle) return std::nullopt;
  const Eigen::Vector3d from = camera.field_from_camera.translation(), way = bundle->middle;
  if (way.z() > -0.05) return std::nullopt;
  const double distance = (radius - from.z()) / way.z();
  if (distance <= radius) return std::nullopt;
  const double half_angle = std::asin(radius / distance);
  const double visible = bundle->solid_angle / (2 * std::numbers::pi * (1 - std::cos(half_angle)));
  // the second moment of a disc is a quarter of its squared radius
  const double width = bundle->widest / (half_angle * half_angle / 4);
  if (visible < kLeastVisible || visible > kMostVisible || width > kMostWidth) return std::nullopt;

  Candidate candidate{.ball = {}, .visible = visible};
  candidate.ball.place.position = (from + distance * way).head<2>();
  // the middle of a partly hidden disc lies off its centre by at most about the hidden share of its radius
  const double hidden = std::max(0.0, 0.9 - visible) * half_angle;
  const double angle = std::hypot(kMiddleDeviation / camera.projection.intrinsics.focal_x, hidden);
  candidate.ball.place.covariance = plane_covariance(way, distance, angle);
  return candidate;
}

}  // namespace

std::optional<SeenBall> find_ball(const DepthFrame& picture, const Camera& camera, const BallLook& look) {
  std::optional<Candidate> best;
  const auto off = [](const Candidate& candidate) { return std::abs(std::log(candidate.visible)); };
  for (const Spot& spot : spots_of_colour(picture, look.colours, kFewestPixels)) {
    const auto candidate = candidate_of(spot, camera, look.radius);
    if (candidate && (!best || off(*candidate) < off(*best))) best = candidate;
  }
  if (!best) return std::nullopt;
  return best->ball;
}

}  // namespace robot::truth::tags
