#include "robot/truth/tags/tag_pose.h"

#include <Eigen/Cholesky>
#include <Eigen/LU>
#include <Eigen/SVD>
#include <array>
#include <cmath>
#include <cstddef>
#include <numbers>

namespace robot::truth::tags {
namespace {

constexpr double kHeightDeviation = 0.01;                      // [m] of a walking robot
constexpr double kTiltDeviation = 5 * std::numbers::pi / 180;  // [rad] likewise

using Residuals = Eigen::Matrix<double, 12, 1>;  // 8 of the corners, the shine, the height, 2 of the tilt
using Vector7 = Eigen::Matrix<double, 7, 1>;     // 3 of the centre, 3 of the turn, the shine
using Matrix7 = Eigen::Matrix<double, 7, 7>;

/// The problem of least squares for one tag.
struct Problem {
  const Camera& camera;
  const Corners& corners;
  double edge;
  std::optional<double> height;  // [m] of a standing robot's tag; nothing: the pose is free
};

/// A solution.
struct State {
  Eigen::Isometry3d field_from_tag;
  double shine = kShine;  // [px]
};

std::array<Eigen::Vector3d, 4> corners_of_print(double edge) {
  const double half = edge / 2;
  return {{{-half, -half, 0}, {half, -half, 0}, {half, half, 0}, {-half, half, 0}}};
}

std::optional<Residuals> residuals_of(const Problem& problem, const State& state) {
  const auto expected = corners_in_picture(problem.camera, state.field_from_tag, problem.edge, state.shine);
  if (!expected) return std::nullopt;
  Residuals residuals = Residuals::Zero();
  for (std::size_t i = 0; i < 4; ++i)
    residuals.segment<2>(static_cast<Eigen::Index>(2 * i)) = ((*expected)[i] - problem.corners[i]) / kCornerDeviation;
  residuals[8] = (state.shine - kShine) / kShineDeviation;
  if (!problem.height) return residuals;
  residuals[9] = (state.field_from_tag.translation().z() - *problem.height) / kHeightDeviation;
  residuals.tail<2>() = state.field_from_tag.linear().col(2).head<2>() / kTiltDeviation;
  return residuals;
}

/// Returns the state after a step: moved [m, field], turned [rad] about the field's axes at the tag's centre, more shine.
State moved(const State& state, const Vector7& step) {
  State result = state;
  const Eigen::Vector3d turn = step.segment<3>(3);
  if (turn.norm() > 0)
    result.field_from_tag.linear() = Eigen::AngleAxisd(turn.norm(), turn.normalized()) * state.field_from_tag.linear();
  result.field_from_tag.translation() += step.head<3>();
  result.shine += step[6];
  return result;
}

std::optional<Eigen::Matrix<double, 12, 7>> derivative_of(const Problem& problem, const State& state) {
  constexpr double kStep = 1e-6;  // [m], [rad], [px]
  Eigen::Matrix<double, 12, 7> derivative;
  for (Eigen::Index i = 0; i < 7; ++i) {
    const auto more = residuals_of(problem, moved(state, kStep * Vector7::Unit(i)));
    const auto less = residuals_of(problem, moved(state, -kStep * Vector7::Unit(i)));
    if (!more || !less) return std::nullopt;
    derivative.col(i) = (*more - *less) / (2 * kStep);
  }
  return derivative;
}

/// Returns the pose of least squares near `start`, by Levenberg and Marquardt.
std::optional<TagPose> solve(const Problem& problem, const Eigen::Isometry3d& start) {
  constexpr int kMostSteps = 30;
  State state{.field_from_tag = start};
  auto residuals = residuals_of(problem, state);
  auto derivative = derivative_of(problem, state);
  double damping = 1e-3;
  for (int step = 0; residuals && derivative && step < kMostSteps; ++step) {
    Matrix7 damped = derivative->transpose() * *derivative;
    damped.diagonal() *= 1 + damping;
    const Vector7 way = -damped.ldlt().solve(derivative->transpose() * *residuals);
    const State next = moved(state, way);
    const auto next_residuals = residuals_of(problem, next);
    const bool better = next_residuals && next_residuals->squaredNorm() <= residuals->squaredNorm();
    damping = better ? damping / 10 : damping * 10;
    if (better) {
      state = next;
      residuals = next_residuals;
      derivative = derivative_of(problem, state);
    }
    if (way.norm() < 1e-7) break;
  }
  if (!residuals || !derivative) return std::nullopt;
  const Matrix7 covariance = (derivative->transpose() * *derivative).inverse();
  if (!covariance.allFinite()) return std::nullopt;
  return TagPose{.field_from_tag = state.field_from_tag,
                 .covariance = covariance.topLeftCorner<6, 6>(),
                 .cost = residuals->squaredNorm()};
}

/// Returns the pose of a flat tag at `height`, from the rays of its corners.
std::optional<Eigen::Isometry3d> flat_pose(const Problem& problem, double height) {
  Eigen::Vector2d middle = Eigen::Vector2d::Zero(), right = Eigen::Vector2d::Zero();
  const auto print = corners_of_print(problem.edge);
  for (std::size_t i = 0; i < 4; ++i) {
    const auto place = problem.camera.on_plane(problem.corners[i], height);
    if (!place) return std::nullopt;
    middle += *place / 4;
    // turned back by the corner's own direction: the sum points to the right edge
    right += Eigen::Vector2d{print[i].x() * place->x() + print[i].y() * place->y(),
                             print[i].x() * place->y() - print[i].y() * place->x()};
  }
  Eigen::Isometry3d pose = Eigen::Isometry3d::Identity();
  pose.linear() = Eigen::AngleAxisd(std::atan2(right.y(), right.x()), Eigen::Vector3d::UnitZ()).toRotationMatrix();
  pose.translation() << middle, height;
  return pose;
}

/// Returns the pose [camera] from the homography between the print and the plane z = 1 of the camera.
std::optional<Eigen::Isometry3d> homography_pose(const Problem& problem) {
  Eigen::Matrix<double, 8, 8> equations;
  Eigen::Matrix<double, 8, 1> seen;
  const auto print = corners_of_print(problem.edge);
  for (std::size_t i = 0; i < 4; ++i) {
    const auto ray = problem.camera.projection.ray(problem.corners[i]);
    if (!ray) return std::nullopt;
    const double x = print[i].x(), y = print[i].y();
    const auto row = static_cast<Eigen::Index>(2 * i);
    equations.row(row) << x, y, 1, 0, 0, 0, -ray->x() * x, -ray->x() * y;
    equations.row(row + 1) << 0, 0, 0, x, y, 1, -ray->y() * x, -ray->y() * y;
    seen.segment<2>(row) = ray->head<2>();
  }
  const Eigen::Matrix<double, 8, 1> h = equations.partialPivLu().solve(seen);
  if (!h.allFinite()) return std::nullopt;
  const Eigen::Vector3d x{h[0], h[3], h[6]}, y{h[1], h[4], h[7]};
  const double scale = std::sqrt(x.norm() * y.norm());
  if (!(scale > 0)) return std::nullopt;
  Eigen::Matrix3d axes;
  axes << x / scale, y / scale, x.cross(y) / (scale * scale);
  const Eigen::JacobiSVD<Eigen::Matrix3d> parts(axes, Eigen::ComputeFullU | Eigen::ComputeFullV);
  Eigen::Isometry3d pose = Eigen::Isometry3d::Identity();
  pose.linear() = parts.matrixU() * parts.matrixV().transpose();
  pose.translation() = Eigen::Vector3d{h[2], h[5], 1} / scale;
  return pose;
}

/// Returns the other pose [camera] that shows a small square almost alike: its normal mirrored at the line of sight.
Eigen::Isometry3d mirrored_pose(const Eigen::Isometry3d& camera_from_tag) {
  const Eigen::Vector3d sight = camera_from_tag.translation().normalized();
  const Eigen::Vector3d normal = camera_from_tag.linear().col(2);
  const Eigen::Vector3d other = 2 * sight.dot(normal) * sight - normal;
  Eigen::Isometry3d result = camera_from_tag;
  result.linear() = Eigen::Quaterniond::FromTwoVectors(normal, other) * camera_from_tag.linear();
  return result;
}

}  // namespace

std::optional<Corners> corners_in_picture(const Camera& camera, const Eigen::Isometry3d& field_from_tag, double edge,
                                          double shine) {
  Corners full;
  const auto print = corners_of_print(edge);
  for (std::size_t i = 0; i < 4; ++i) {
    const auto pixel = camera.pixel(field_from_tag * print[i]);
    if (!pixel) return std::nullopt;
    full[i] = *pixel;
  }
  Corners corners = full;
  for (std::size_t i = 0; i < 4; ++i) {
    const Eigen::Vector2d next = full[(i + 1) % 4] - full[i], last = full[(i + 3) % 4] - full[i];
    corners[i] += shine * (next.normalized() + last.normalized());
  }
  return corners;
}

std::optional<TagPose> standing_pose(const Camera& camera, const Corners& corners, double edge, double height) {
  const Problem problem{camera, corners, edge, height};
  const auto start = flat_pose(problem, height);
  return start ? solve(problem, *start) : std::nullopt;
}

std::optional<TagPose> free_pose(const Camera& camera, const Corners& corners, double edge) {
  const Problem problem{camera, corners, edge, std::nullopt};
  const auto start = homography_pose(problem);
  if (!start) return std::nullopt;
  const auto one = solve(problem, camera.field_from_camera * *start);
  const auto other = solve(problem, camera.field_from_camera * mirrored_pose(*start));
  if (!one || !other) return one ? one : other;
  return one->cost <= other->cost ? one : other;
}

}  // namespace robot::truth::tags
