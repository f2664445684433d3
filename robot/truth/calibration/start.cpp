#include "robot/truth/calibration/start.h"

#include <Eigen/LU>
#include <Eigen/SVD>
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace robot::truth {
namespace {

constexpr double kFarthestMiss = 0.03;    // of the picture's width: a farther miss costs no more
constexpr double kMirroredBetter = 0.25;  // a mirrored field whose cost is less than this share is the true one
constexpr std::size_t kMostFours = 400;   // sets of four sightings that are tried

/// A landmark on the carpet and the ray of its click.
struct CarpetSighting {
  Eigen::Vector2d place;  // [m, field]
  Eigen::Vector3d ray;    // [sensor] z = 1
};
using Poses = std::vector<Eigen::Isometry3d>;

/// Adds the pose in which two rays meet the carpet's plane at their places.
void add_pose_of_two(const Ground& ground, const CarpetSighting& a, const CarpetSighting& b, Poses& poses) {
  const Eigen::Vector3d& up = ground.normal;
  const Eigen::Vector3d point_a = a.ray * (-ground.height / up.dot(a.ray));
  const Eigen::Vector3d point_b = b.ray * (-ground.height / up.dot(b.ray));
  const Eigen::Vector2d way = b.place - a.place;
  if (!(point_a.z() > 0 && point_b.z() > 0) || way.norm() < 0.1) return;

  // the field's axes in the frame of the sensor
  const Eigen::Vector3d along = (point_b - point_a).normalized(), across = up.cross(along);
  const Eigen::Vector3d x = (way.x() * along - way.y() * across) / way.norm();
  Eigen::Isometry3d pose = Eigen::Isometry3d::Identity();
  pose.linear() << x.transpose(), up.cross(x).transpose(), up.transpose();
  const Eigen::Vector3d middle = pose.linear() * (point_a + point_b) / 2;
  pose.translation() << (a.place + b.place) / 2 - middle.head<2>(), ground.height;
  poses.push_back(pose);
}

/// Returns the matrix that brings places of the carpet (x, y, 1) to multiples of the four rays.
Eigen::Matrix3d homography_of(const std::array<const CarpetSighting*, 4>& four) {
  Eigen::Matrix<double, 8, 8> equations;
  Eigen::Matrix<double, 8, 1> right;
  Eigen::Index at = 0;
  for (const CarpetSighting* sighting : four) {
    const Eigen::RowVector3d place = sighting->place.homogeneous().transpose();
    const Eigen::Vector3d& ray = sighting->ray;
    equations.row(at) << place, Eigen::RowVector3d::Zero(), -ray.x() * place.head<2>();
    equations.row(at + 1) << Eigen::RowVector3d::Zero(), place, -ray.y() * place.head<2>();
    right.segment<2>(at) = ray.head<2>();
    at += 2;
  }
  const Eigen::Matrix<double, 8, 1> solution = equations.partialPivLu().solve(right);
  Eigen::Matrix3d homography;
  homography << solution.head<3>().transpose(), solution.segment<3>(3).transpose(), solution.tail<2>().transpose(), 1;
  return homography;
}

/// Adds the pose that shows four places of the carpet along their rays, if the sensor is above the carpet.
void add_pose_of_four(const std::array<const CarpetSighting*, 4>& four, Poses& poses) {
  Eigen::Matrix3d sensor_from_place = homography_of(four);
  const double size = (sensor_from_place.col(0).norm() + sensor_from_place.col(1).norm()) / 2;
  if (!(size > 0) || !sensor_from_place.allFinite()) return;
  sensor_from_place /= size;
  // the places are in front of the sensor
  if (sensor_from_place.row(2).dot(four[0]->place.homogeneous()) < 0) sensor_from_place = -sensor_from_place;

  Eigen::Matrix3d axes = sensor_from_place;
  axes.col(2) = axes.col(0).cross(axes.col(1));
  const Eigen::JacobiSVD<Eigen::Matrix3d> nearest(axes, Eigen::ComputeFullU | Eigen::ComputeFullV);
  Eigen::Isometry3d sensor_from_field = Eigen::Isometry3d::Identity();
  sensor_from_field.linear() = nearest.matrixU() * nearest.matrixV().transpose();
  sensor_from_field.translation() = sensor_from_place.col(2);
  const Eigen::Isometry3d pose = sensor_from_field.inverse();
  if (pose.linear().determinant() > 0 && pose.translation().z() > 0) poses.push_back(pose);
}

Poses poses_of_twos(const std::vector<CarpetSighting>& all, const Ground& ground) {
  Poses poses;
  for (std::size_t a = 0; a < all.size(); ++a)
    for (std::size_t b = a + 1; b < all.size(); ++b) add_pose_of_two(ground, all[a], all[b], poses);
  return poses;
}

Poses poses_of_fours(const std::vector<CarpetSighting>& all) {
  std::vector<std::array<const CarpetSighting*, 4>> fours;
  for (std::size_t a = 0; a < all.size(); ++a)
    for (std::size_t b = a + 1; b < all.size(); ++b)
      for (std::size_t c = b + 1; c < all.size(); ++c)
        for (std::size_t d = c + 1; d < all.size(); ++d) fours.push_back({&all[a], &all[b], &all[c], &all[d]});
  Poses poses;
  const std::size_t each = fours.size() / kMostFours + 1;
  for (std::size_t i = 0; i < fours.size(); i += each) add_pose_of_four(fours[i], poses);
  return poses;
}

/// A view and the cost of its misses, far ones limited.
struct Candidate {
  View view;
  double cost = std::numeric_limits<double>::infinity();
};

Candidate best_candidate(const std::vector<Sighting>& sightings, const Projection& camera,
                         const std::optional<Ground>& ground) {
  std::vector<CarpetSighting> on_carpet;
  for (const Sighting& sighting : sightings)
    if (const auto ray = camera.ray(sighting.pixel)) on_carpet.push_back({sighting.place.head<2>(), *ray});

  const double farthest = kFarthestMiss * camera.intrinsics.width;
  Candidate best;
  for (const auto& pose : ground ? poses_of_twos(on_carpet, *ground) : poses_of_fours(on_carpet)) {
    const View view{.field_from_sensor = pose, .camera = camera};
    double cost = 0;
    for (const Sighting& sighting : sightings) cost += std::pow(std::min(miss_of(view, sighting), farthest), 2);
    if (cost < best.cost) best = {view, cost};
  }
  return best;
}

}  // namespace

Result<View> start_view(const std::vector<Sighting>& sightings, const Projection& camera,
                        const std::optional<Ground>& ground) {
  std::vector<Sighting> mirrored = sightings;
  for (Sighting& sighting : mirrored) sighting.place.y() *= -1;
  const Candidate best = best_candidate(sightings, camera, ground);
  if (best_candidate(mirrored, camera, ground).cost < kMirroredBetter * best.cost)
    return Error{"the clicks fit a mirrored field: exchange the landmarks of left and right"};
  if (!std::isfinite(best.cost))
    return Error{"no place of the sensor above the carpet fits the clicks: check each one"};
  return best.view;
}

}  // namespace robot::truth
