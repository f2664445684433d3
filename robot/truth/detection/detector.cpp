#include "robot/truth/detection/detector.h"

#include <algorithm>
#include <cmath>

#include "robot/truth/detection/checks.h"
#include "robot/truth/detection/goals.h"
#include "robot/truth/detection/robot_finder.h"

namespace robot::truth {
namespace {

constexpr double kUsualUnit = 0.001;  // [m] of nearly all sensors

Sight make_sight(const SensorPose& pose, const sim::field::Field& field, const DetectorOptions& options, double unit) {
  return {pose, field, unit, options.ball_radius / 2};
}

}  // namespace

Result<Detector> Detector::create(const SensorPose& pose, const sim::field::Field& field,
                                  const DetectorOptions& options) {
  for (const Result<void>& checked : {check(pose), check(field), check(options)})
    if (!checked) return checked.failure();
  return Detector(pose, field, options);
}

Detector::Detector(const SensorPose& pose, const sim::field::Field& field, const DetectorOptions& options)
    : field_(field),
      options_(options),
      unit_(kUsualUnit),
      sight_(make_sight(pose, field, options, unit_)),
      grid_(sight_.half_size()),
      orange_ball_finder_(pose, options),
      ball_shape_finder_(pose, options.ball_radius),
      noticing_(static_cast<std::size_t>(pose.intrinsics.width)) {}

/// Another unit is another sensor driver, so that its background must be learned again.
void Detector::use_unit(double unit) {
  if (unit == unit_) return;
  unit_ = unit;
  sight_ = make_sight(sight_.pose(), field_, options_, unit);
  background_ = {};
  background_is_new_ = false;
}

void Detector::use_background() {
  if (!background_is_new_) return;
  sight_.set_background(background_.median());
  background_is_new_ = false;
}

Result<void> Detector::learn_background(const DepthFrame& frame) {
  if (const Result<void> checked = check(frame, sight_.pose().intrinsics); !checked) return checked.failure();
  use_unit(frame.unit);
  background_.add(frame.depth);
  background_is_new_ = true;
  return {};
}

Result<Detections> Detector::detect(const DepthFrame& frame) {
  if (const Result<void> checked = check(frame, sight_.pose().intrinsics); !checked) return checked.failure();
  use_unit(frame.unit);
  use_background();
  scan(frame);
  Detections seen;
  seen.capture_ns = frame.capture_ns;
  find_robots(sight_, options_, grid_, seen.robots);
  const bool by_colour = options_.orange_ball && !frame.rgb.empty();
  seen.ball =
      by_colour ? orange_ball_finder_.find(sight_, frame) : ball_shape_finder_.find(sight_, frame, grid_, seen.robots);
  return seen;
}

void Detector::scan(const DepthFrame& frame) {
  grid_.clear();
  ball_shape_finder_.clear();
  for (int row = sight_.first_row(); row < sight_.end_row(); ++row) scan_row(frame, row);
  remove_goals(field_, sight_, grid_);
}

void Detector::scan_row(const DepthFrame& frame, int row) {
  const auto [first, end] = sight_.columns(row);
  const std::uint16_t* const depths =
      &frame.depth[static_cast<std::size_t>(row) * static_cast<std::size_t>(frame.intrinsics.width)];
  const std::uint16_t *const nearest = sight_.nearest(row), *const count = sight_.count(row);
  // without branches, since noise makes them unpredictable
  std::size_t found = 0;
  for (int column = first; column < end; ++column) {
    noticing_[found] = column;
    found += static_cast<std::uint16_t>(depths[column] - nearest[column]) < count[column] ? 1 : 0;
  }
  for (std::size_t i = 0; i < found; ++i) add_point(row, noticing_[i], depths[noticing_[i]]);
}

void Detector::add_point(int row, int column, std::uint16_t depth) {
  constexpr float kLowest = 0.05F;                    // [m] the thinnest part of a lying robot
  constexpr float kSure = 2.5F;                       // standard deviations of the height
  const LayerHeights heights(options_.robot_height);  // folded into the loop by the compiler
  const Eigen::Vector3f ray = sight_.ray(row, column), point = sight_.eye() + static_cast<float>(depth) * ray;
  const float z = sight_.metres(depth);
  const float noise = kSure * std::abs(ray.z()) / sight_.metres(1) * sight_.deviation(depth);
  if (point.z() < static_cast<float>(2 * options_.ball_radius) + noise) ball_shape_finder_.add(row, column);
  const Layer layer = heights.layer_at(point.z());
  if (layer == Layer::low && point.z() < std::max(kLowest, noise)) return;
  grid_.add(layer, point.x(), point.y(), z * z * sight_.pixel_area(), point.z());
}

}  // namespace robot::truth
