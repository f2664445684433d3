#include "robot/truth/detection/sight.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace robot::truth {
namespace {

using Eigen::Vector2d;
using Eigen::Vector3d;
using Eigen::Vector3f;

/// A lower threshold lets more than a tenth of the carpet pass; a higher one loses small balls at 5 m.
constexpr double kNotice = 1.8;  // standard deviations

constexpr double kAround = 0.4;  // [m] outside of the carpet, so that a person at its edge is whole

/// Returns the standard deviation [m] of a depth, by noise and by rounding to steps.
double total_deviation(const Intrinsics& intrinsics, double z) {
  return std::hypot(DepthNoise::deviation(z), DepthNoise::step(intrinsics, z) / std::sqrt(12.));
}

/// A part of a ray, in lengths of the ray.
struct Stretch {
  double near = 0, far = std::numeric_limits<double>::infinity();
};

/// Shortens a stretch to the part between -half_size and half_size on one axis.
void cut(Stretch& stretch, double half_size, double eye, double ray) {
  const double one = (-half_size - eye) / ray, other = (half_size - eye) / ray;
  stretch.near = std::max(stretch.near, std::min(one, other));
  stretch.far = std::min(stretch.far, std::max(one, other));
}

}  // namespace

Sight::Sight(const SensorPose& pose, const sim::field::Field& field, double unit, double lowest)
    : pose_(pose),
      lowest_(lowest),
      half_size_(Eigen::Vector2f(field.length, field.width).cast<double>() / 2 +
                 Vector2d::Constant(static_cast<double>(field.border) + kAround)),
      eye_(pose.field_from_sensor.translation().cast<float>()),
      metres_(static_cast<float>(unit * pose.depth_scale)),
      pixel_area_(static_cast<float>(1 / (pose.intrinsics.focal_x * pose.intrinsics.focal_y))) {
  make_rays(unit);
  nearest_.resize(row_rays_.size() * column_rays_.size());
  count_.resize(nearest_.size());
  set_limits();
}

void Sight::make_rays(double unit) {
  const Intrinsics& image = pose_.intrinsics;
  const double step = unit * pose_.depth_scale;
  const Eigen::Matrix3d turned = pose_.field_from_sensor.linear() * step;
  for (int row = 0; row < image.height; ++row) {
    const Vector3d ray = pose_.ray(image.centre_x, row + 0.5);
    row_rays_.emplace_back((turned * ray).cast<float>());
    down_.push_back(static_cast<float>(ray.y()));
  }
  for (int column = 0; column < image.width; ++column) {
    const double across = pose_.ray(column + 0.5, image.centre_y).x();
    column_rays_.emplace_back((turned.col(0) * across).cast<float>());
    across_.push_back(static_cast<float>(across));
  }
  for (std::size_t depth = kDeviationStep / 2; depth < 65536; depth += kDeviationStep)
    deviations_.push_back(static_cast<float>(total_deviation(image, static_cast<double>(depth) * step)));
}

void Sight::set_background(std::vector<std::uint16_t> depths) {
  background_ = std::move(depths);
  set_limits();
}

void Sight::set_limits() {
  for (int row = 0; row < pose_.intrinsics.height; ++row)
    for (int column = 0; column < pose_.intrinsics.width; ++column) set_limits(row, column);
  cut_away();
}

void Sight::set_limits(int row, int column) {
  const Vector3f step = ray(row, column);
  const double fall = -static_cast<double>(step.z());
  const double metres = static_cast<double>(metres_), empty = static_cast<double>(background(row, column));
  Stretch noticed;
  for (int axis = 0; axis < 2; ++axis)
    cut(noticed, half_size_[axis], static_cast<double>(eye_[axis]), static_cast<double>(step[axis]));
  if (std::isfinite(empty)) {
    const double high = fall > 0 ? lowest_ / fall : 0;
    const double noise = kNotice * total_deviation(pose_.intrinsics, empty) / metres;
    noticed.far = std::min(noticed.far, empty / metres - std::max(high, noise));
  }
  const double near = std::clamp(std::ceil(noticed.near), 1., 65535.), far = std::clamp(noticed.far, 0., 65535.);
  nearest_[index(row, column)] = static_cast<std::uint16_t>(near);
  count_[index(row, column)] = static_cast<std::uint16_t>(std::max(far - near, 0.));
}

void Sight::cut_away() {
  columns_.assign(row_rays_.size(), {});
  first_row_ = pose_.intrinsics.height, end_row_ = 0;
  for (int row = 0; row < pose_.intrinsics.height; ++row) {
    const std::uint16_t* const depths = count(row);
    Columns columns{0, pose_.intrinsics.width};
    while (columns.first < columns.end && depths[columns.first] == 0) ++columns.first;
    while (columns.first < columns.end && depths[columns.end - 1] == 0) --columns.end;
    columns_[static_cast<std::size_t>(row)] = columns;
    if (columns.first == columns.end) continue;
    first_row_ = std::min(first_row_, row);
    end_row_ = row + 1;
  }
}

float Sight::deviation_at(const Vector3f& place) const {
  return static_cast<float>(total_deviation(pose_.intrinsics, static_cast<double>(depth_of(place))));
}

float Sight::depth_of(const Vector3f& place) const {
  const Vector3f forward = pose_.field_from_sensor.linear().col(2).cast<float>();
  return forward.dot(place - eye_);
}

float Sight::background(int row, int column) const {
  if (const std::size_t pixel = index(row, column); !background_.empty() && background_[pixel] != 0)
    return metres(background_[pixel]);
  const float fall = -ray(row, column).z();
  return fall > 0 ? eye_.z() / fall * metres_ : std::numeric_limits<float>::infinity();
}

bool Sight::on_carpet(const Vector2d& place) const {
  return ((half_size_ - place.cwiseAbs()).array() >= kAround).all();
}

}  // namespace robot::truth
