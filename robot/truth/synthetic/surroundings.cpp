#include "robot/truth/synthetic/surroundings.h"

#include <algorithm>
#include <cmath>

namespace robot::truth {
namespace {

using Eigen::Vector3d;

/// The lines of a field.
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
  bool white(double x, double y) const {
    x = std::abs(x), y = std::abs(y);
    if (on_outline(x, y, length_ / 2, width_ / 2)) return true;
    if (x < half_line_ && y < width_ / 2) return true;
    if (std::abs(std::hypot(x, y) - circle_) < half_line_) return true;
    if (std::hypot(x - length_ / 2 + mark_, y) < 2 * half_line_) return true;
    for (const Area& area : areas_)
      if (area.length > 0 && on_outline(length_ / 2 - x, y, area.length, area.width / 2)) return true;
    return false;
  }

 private:
  struct Area {
    double length, width;
  };

  /// Reports whether a place is on the two sides, away from the origin, of a box between the origin and a corner.
  bool on_outline(double x, double y, double corner_x, double corner_y) const {
    const double beyond = std::max(x - corner_x, y - corner_y);
    return x >= -half_line_ && std::abs(beyond) <= half_line_;
  }

  double half_line_, length_, width_, circle_, mark_;
  Area areas_[2];
};

/// The floor and the walls, hit by rays from one place.
class Hall {
 public:
  Hall(const Surroundings& surroundings, const Vector3d& eye)
      : lines_(surroundings.field),
        carpet_x_(static_cast<double>(surroundings.field.length) / 2 + static_cast<double>(surroundings.field.border)),
        carpet_y_(static_cast<double>(surroundings.field.width) / 2 + static_cast<double>(surroundings.field.border)),
        walls_(surroundings.walls),
        eye_(eye) {}

  /// Sets the distance, in lengths of the ray [field], and the material that a ray meets.
  void cast(const Vector3d& ray, float& distance, Material& material) const {
    const double x = ray.x(), y = ray.y(), z = ray.z();
    double nearest = kFar;
    if (z < 0) nearest = -eye_.z() / z, material = floor_at(eye_.x() + nearest * x, eye_.y() + nearest * y);
    if (walls_ > 0)
      for (const double wall : {distance_of_wall(eye_.x(), x, carpet_x_), distance_of_wall(eye_.y(), y, carpet_y_)})
        if (wall > 0 && wall < nearest) nearest = wall, material = Material::wall;
    distance = static_cast<float>(nearest);
  }

 private:
  /// Returns the distance of the wall beyond one end of the carpet, negative when it is behind the sensor.
  double distance_of_wall(double eye, double ray, double carpet) const {
    return ray != 0 ? (std::copysign(carpet + walls_, ray) - eye) / ray : -1;
  }
  Material floor_at(double x, double y) const {
    if (std::abs(x) > carpet_x_ || std::abs(y) > carpet_y_) return Material::wall;
    return lines_.white(x, y) ? Material::line : Material::carpet;
  }

  Lines lines_;
  double carpet_x_, carpet_y_;  // half of its size [m]
  double walls_;
  Vector3d eye_;  // [field]
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
  const Hall hall(surroundings, pose.field_from_sensor.translation());
  const Eigen::Matrix3d turned = pose.field_from_sensor.linear();
  const Vector3d step = turned.col(0) / image.focal_x;
  Cast cast;
  cast.depth.assign(static_cast<std::size_t>(image.width) * static_cast<std::size_t>(image.height), kFar);
  cast.material.assign(cast.depth.size(), Material::nothing);
  std::size_t pixel = 0;
  for (int row = 0; row < image.height; ++row) {
    Vector3d ray = turned * pose.ray(0.5, row + 0.5);
    for (int column = 0; column < image.width; ++column, ++pixel, ray += step)
      hall.cast(ray, cast.depth[pixel], cast.material[pixel]);
  }
  if (surroundings.goals) draw_goals(surroundings.field, pose, cast);
  return cast;
}

}  // namespace robot::truth
