// The pixels of a sensor above a field: their rays, their noise, and the depths that belong to something on the carpet.
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <vector>

#include "robot/truth/frame/sensor_pose.h"
#include "sim/field/field.h"

namespace robot::truth {

/// Everything about a sensor at its place that does not depend on an image, computed once.
///
/// A pixel notices a depth that is nearer than the empty field by 1.8 standard deviations of the noise. It must be on the
/// carpet or at most 0.4 m outside of it. Pixels that can never notice anything are cut away.
class Sight {
 public:
  /// `unit` [m] is a step of the measured depths; things below `lowest` [m] are never noticed.
  Sight(const SensorPose& pose, const sim::field::Field& field, double unit, double lowest);

  /// Takes the measured depths of the empty field, which replace those of a plane; 0: unknown.
  void set_background(std::vector<std::uint16_t> depths);

  /// The part of the image that can notice something; the ends are one behind.
  struct Columns {
    int first = 0, end = 0;
  };
  int first_row() const { return first_row_; }
  int end_row() const { return end_row_; }
  Columns columns(int row) const { return columns_[static_cast<std::size_t>(row)]; }

  /// The noticed depths of a row's pixels: from `nearest` on, this many.
  const std::uint16_t* nearest(int row) const { return &nearest_[index(row, 0)]; }
  const std::uint16_t* count(int row) const { return &count_[index(row, 0)]; }
  /// Reports whether a pixel of an image notices something. A depth of 0 is never noticed.
  bool notices(const DepthFrame& frame, int row, int column) const {
    const std::size_t pixel = index(row, column);
    return static_cast<std::uint16_t>(frame.depth[pixel] - nearest_[pixel]) < count_[pixel];
  }

  /// Returns the place of a pixel in the vectors of an image.
  std::size_t index(int row, int column) const {
    return static_cast<std::size_t>(row) * static_cast<std::size_t>(pose_.intrinsics.width) +
           static_cast<std::size_t>(column);
  }

  /// Returns the way [m, field] of a ray through a pixel's centre while the measured depth grows by a step.
  Eigen::Vector3f ray(int row, int column) const {
    return row_rays_[static_cast<std::size_t>(row)] + column_rays_[static_cast<std::size_t>(column)];
  }
  /// Returns the same direction in the frame `sensor`, with z = 1.
  Eigen::Vector3f sensor_ray(int row, int column) const {
    return {across_[static_cast<std::size_t>(column)], down_[static_cast<std::size_t>(row)], 1};
  }
  const Eigen::Vector3f& eye() const { return eye_; }  // [m, field]

  /// Returns the true depth [m] of a measured one.
  float metres(std::uint16_t depth) const { return static_cast<float>(depth) * metres_; }
  /// Returns the standard deviation [m] of a measured depth, and of the depth of a place [m, field].
  float deviation(std::uint16_t depth) const { return deviations_[depth / kDeviationStep]; }
  float deviation_at(const Eigen::Vector3f& place) const;
  /// Returns the depth [m] of a place [m, field].
  float depth_of(const Eigen::Vector3f& place) const;
  /// Returns the depth [m] of the empty field at a pixel; infinite where there is none.
  float background(int row, int column) const;
  /// Returns the area [m²], square to the ray, of a pixel at 1 m.
  float pixel_area() const { return pixel_area_; }

  /// Reports whether a place [m, field] is on the carpet.
  bool on_carpet(const Eigen::Vector2d& place) const;
  /// Returns half the size [m] of the carpet and its surroundings.
  const Eigen::Vector2d& half_size() const { return half_size_; }
  const SensorPose& pose() const { return pose_; }

 private:
  static constexpr std::size_t kDeviationStep = 32;  // measured depths with the same deviation

  void make_rays(double unit);
  void set_limits();
  void set_limits(int row, int column);
  void cut_away();

  SensorPose pose_;
  double lowest_;
  Eigen::Vector2d half_size_;
  Eigen::Vector3f eye_;
  float metres_, pixel_area_;
  std::vector<Eigen::Vector3f> row_rays_, column_rays_;
  std::vector<float> across_, down_, deviations_;
  std::vector<std::uint16_t> nearest_, count_, background_;
  std::vector<Columns> columns_;
  int first_row_ = 0, end_row_ = 0;
};

}  // namespace robot::truth
