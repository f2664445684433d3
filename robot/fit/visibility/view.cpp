#include "robot/fit/visibility/view.h"

#include "robot/fit/math/angles.h"

#include <algorithm>
#include <cmath>

namespace robot::fit {
namespace {

constexpr double kSloppy = 0.05;  // error of the length of a unit vector

/// Returns the smaller way to either border from an angle that grows towards the second.
double way_inside(double angle, double to_first, double to_second) {
  return std::min(to_first + angle, to_second - angle);
}

bool is_whole(const foresight::CameraMatrix& matrix) {
  if (matrix.rotation_size() != 9 || matrix.width() == 0 || matrix.height() == 0) return false;
  for (const float number : matrix.rotation())
    if (!std::isfinite(number)) return false;
  const auto ahead = [&](int row) { return static_cast<double>(matrix.rotation(3 * row + 2)); };
  return std::abs(std::hypot(ahead(0), ahead(1), ahead(2)) - 1) < kSloppy && std::isfinite(matrix.x()) &&
         std::isfinite(matrix.y()) && std::isfinite(matrix.z()) && matrix.focal_x() > 0 && matrix.focal_y() > 0 &&
         std::isfinite(matrix.centre_x()) && std::isfinite(matrix.centre_y());
}

}  // namespace

View::Inside View::inside(double point_x, double point_y, double point_z) const {
  const double px = point_x - x, py = point_y - y, pz = point_z - z;
  const auto& r = rotation;
  const double to_right = r[0] * px + r[3] * py + r[6] * pz;
  const double below = r[1] * px + r[4] * py + r[7] * pz;
  const double ahead = r[2] * px + r[5] * py + r[8] * pz;
  const double off = wrapped(std::atan2(py, px) - bearing);
  const double depression = std::atan2(-pz, std::hypot(px, py));
  return {.across = std::min(way_inside(std::atan2(to_right, ahead), left, right), way_inside(-off, left, right)),
          .upright = std::min(way_inside(std::atan2(below, ahead), up, down), way_inside(depression - tilt, up, down))};
}

std::optional<View> view_of(const foresight::CameraMatrix& matrix, std::uint64_t capture_ns) {
  if (!is_whole(matrix)) return std::nullopt;
  View view{.capture_ns = capture_ns, .x = matrix.x(), .y = matrix.y(), .z = matrix.z()};
  std::ranges::copy(matrix.rotation(), view.rotation.begin());
  view.left = std::atan2(matrix.centre_x(), matrix.focal_x());
  view.right = std::atan2(static_cast<double>(matrix.width()) - matrix.centre_x(), matrix.focal_x());
  view.up = std::atan2(matrix.centre_y(), matrix.focal_y());
  view.down = std::atan2(static_cast<double>(matrix.height()) - matrix.centre_y(), matrix.focal_y());
  view.bearing = std::atan2(view.rotation[5], view.rotation[2]);
  view.tilt = -std::asin(std::clamp(view.rotation[8], -1., 1.));
  return view;
}

double angle_between(const View& one, const View& other) {
  const auto& a = one.rotation;
  const auto& b = other.rotation;
  const double across = std::hypot(a[5] * b[8] - a[8] * b[5], a[8] * b[2] - a[2] * b[8], a[2] * b[5] - a[5] * b[2]);
  return std::atan2(across, a[2] * b[2] + a[5] * b[5] + a[8] * b[8]);
}

}  // namespace robot::fit
