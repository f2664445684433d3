#include "robot/truth/synthetic/surroundings.h"

#include <cmath>

namespace robot::truth {
namespace {

using Eigen::Vector2d;
using Eigen::Vector3d;

/// The distances of places from the lines of a field.
class Lines {
 public:
  explicit Lines(const sim::field::Field& field)
      : half_line_(static_cast<double>(field.line_width) / 2),
        length_(static_cast<double>(field.length)),
        width_(static_cast<double>(field.width)),
        circle_(static_cast<double>(field.centre_circle_radius)),
        mark_(static_cast<double>(field.penalty_mark)),
        areas_{{static_cast<double>(field.goal_area_length), static_cast<double>(field.goal_area_width)},
               {static_cast<double>(field.penalty_area_length), static_cast<double>(field.penalty_area_width)}} {}

  /// Reports whether a place on the ground [m, field] is white. The lines are the same in all four quarters.
  bool white(const Vector2d& place) const {
    const Vector2d quarter = place.cwiseAbs();
    if (near_box(quarter, {length_ / 2, width_ / 2})) return true;
    if (quarter.x() < half_line_ && quarter.y() < width_ / 2) return true;
    if (std::abs(quarter.norm() - circle_) < half_line_) return true;
    if ((quarter - Vector2d(length_ / 2 - mark_, 0)).norm() < 2 * half_line_) return true;
    for (const Vector2d& area : areas_)
      if (area.x() > 0 && near_box({length_ / 2 - quarter.x(), quarter.y()}, {area.x(), area.y() / 2})) return true;
    return false;
  }

 private:
  /// Reports whether a place is on the outline of a box with one corner at the origin, on its two sides away from it.
  bool near_box(const Vector2d& place, const Vector2d& corner) const {
    const Vector2d beyond = place - corner;
    if (place.x() < -half_line_ || beyond.maxCoeff() > half_line_) return false;
    return beyond.maxCoeff() > -half_line_;
  }

  double half_line_, length_, width_, circle_, mark_;
  Vector2d areas_[2];
};

/// Casts rays at the floor and the walls.
class Hall {
 public:
  Hall(const Surroundings& surroundings, const SensorPose& pose)
      : lines_(surroundings.field),
        carpet_(
            Vector2d(static_cast<double>(surroundings.field.length), static_cast<double>(surroundings.field.width)) /
                2 +
            Vector2d::Constant(static_cast<double>(surroundings.field.border))),
        walls_(surroundings.walls),
        pose_(pose) {}

  /// Sets the depth and the material that a pixel shows.
  void cast(double column, double row, float& depth, Material& material) const {
    const Vector3d eye = pose_.field_from_sensor.translation();
    const Vector3d ray = pose_.field_from_sensor.linear() * pose_.ray(column, row);
    double nearest = kFar;
    if (ray.z() < 0) nearest = -eye.z() / ray.z(), material = floor_at((eye + nearest * ray).head<2>());
    for (int axis = 0; walls_ > 0 && axis < 2; ++axis) {
      const double wall = std::copysign(carpet_[axis] + walls_, ray[axis]);
      const double distance = ray[axis] != 0 ? (wall - eye[axis]) / ray[axis] : 0;
      if (distance > 0 && distance < nearest) nearest = distance, material = Material::wall;
    }
    depth = static_cast<float>(nearest);
  }

 private:
  Material floor_at(const Vector2d& place) const {
    if (((place.cwiseAbs() - carpet_).array() > 0).any()) return Material::wall;
    return lines_.white(place) ? Material::line : Material::carpet;
  }

  Lines lines_;
  Vector2d carpet_;  // half of its size [m]
  double walls_;
  const SensorPose& pose_;
};

void draw_goals(const sim::field::Field& field, const SensorPose& pose, Cast& cast) {
  constexpr float kHeight = 0.8F;  // [m] of the middle of the crossbar
  const Eigen::Isometry3f sensor_from_field = pose.field_from_sensor.inverse().cast<float>();
  const auto bar = [&](const Eigen::Vector3f& from, const Eigen::Vector3f& to) {
    draw({sensor_from_field * from, sensor_from_field * to, field.post_radius, Material::post}, pose.intrinsics, cast);
  };
  for (int post = 0; post < sim::field::kPosts; ++post) {
    const sim::Vec2 foot = sim::field::post_of(field, post);
    bar({foot.x, foot.y, 0}, {foot.x, foot.y, kHeight});
    if (post % 2 == 0) bar({foot.x, foot.y, kHeight}, {foot.x, -foot.y, kHeight});
  }
}

}  // namespace

Cast cast_of(const Surroundings& surroundings, const SensorPose& pose) {
  const Intrinsics& image = pose.intrinsics;
  const Hall hall(surroundings, pose);
  Cast cast;
  cast.depth.assign(static_cast<std::size_t>(image.width) * static_cast<std::size_t>(image.height), kFar);
  cast.material.assign(cast.depth.size(), Material::nothing);
  std::size_t pixel = 0;
  for (int row = 0; row < image.height; ++row)
    for (int column = 0; column < image.width; ++column, ++pixel)
      hall.cast(column + 0.5, row + 0.5, cast.depth[pixel], cast.material[pixel]);
  if (surroundings.goals) draw_goals(surroundings.field, pose, cast);
  return cast;
}

}  // namespace robot::truth
