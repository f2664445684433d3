#include "robot/net/scene/frames.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "robot/net/scene/wire.h"

namespace robot::net {
namespace {

using Matrix = std::array<double, 9>;  // row by row

struct Quaternion {
  double x = 0, y = 0, z = 0, w = 1;
};

std::string transform(std::string_view parent, std::string_view child, const Point3& place, const Quaternion& turn,
                      std::uint64_t capture_ns) {
  const Wire translation = Wire().number(1, place.x).number(2, place.y).number(3, place.z);
  const Wire rotation = Wire().number(1, turn.x).number(2, turn.y).number(3, turn.z).number(4, turn.w);
  const Wire one = Wire()
                       .message(1, timestamp(capture_ns))
                       .text(2, parent)
                       .text(3, child)
                       .message(4, translation)
                       .message(5, rotation);
  return Wire().message(1, one).bytes();
}

/// Reports whether the rows have length 1, are at right angles and form a right hand.
bool is_rotation(const Matrix& m) {
  constexpr double kTolerance = 0.02;
  const auto dot = [&](std::size_t i, std::size_t j) {
    return m[i] * m[j] + m[i + 1] * m[j + 1] + m[i + 2] * m[j + 2];
  };
  for (std::size_t i = 0; i < 9; i += 3)
    for (std::size_t j = 0; j < 9; j += 3)
      if (!(std::abs(dot(i, j) - (i == j ? 1 : 0)) < kTolerance)) return false;
  return m[0] * (m[4] * m[8] - m[5] * m[7]) - m[1] * (m[3] * m[8] - m[5] * m[6]) + m[2] * (m[3] * m[7] - m[4] * m[6]) >
         0;
}

/// Shepperd's method: it divides by the largest part.
Quaternion quaternion_of(const Matrix& m) {
  const double w = 1 + m[0] + m[4] + m[8], x = 1 + m[0] - m[4] - m[8], y = 1 - m[0] + m[4] - m[8],
               z = 1 - m[0] - m[4] + m[8];
  const double largest = std::max({w, x, y, z});
  Quaternion turn;
  if (largest == w)
    turn = {m[7] - m[5], m[2] - m[6], m[3] - m[1], w};
  else if (largest == x)
    turn = {x, m[1] + m[3], m[2] + m[6], m[7] - m[5]};
  else if (largest == y)
    turn = {m[1] + m[3], y, m[5] + m[7], m[2] - m[6]};
  else
    turn = {m[2] + m[6], m[5] + m[7], z, m[3] - m[1]};
  const double length = std::sqrt(turn.x * turn.x + turn.y * turn.y + turn.z * turn.z + turn.w * turn.w);
  return {turn.x / length, turn.y / length, turn.z / length, turn.w / length};
}

}  // namespace

std::optional<std::string> robot_transform(std::string_view frame, const GroundPose& pose, std::uint64_t capture_ns) {
  if (!can_be_drawn(pose.x, pose.y) || !std::isfinite(pose.heading)) return {};
  const Quaternion turn{0, 0, std::sin(pose.heading / 2), std::cos(pose.heading / 2)};
  return transform(kFieldFrame, frame, {pose.x, pose.y, 0}, turn, capture_ns);
}

std::optional<std::string> camera_transform(std::string_view robot_frame, std::string_view camera_frame,
                                            const foresight::CameraMatrix& matrix, std::uint64_t capture_ns) {
  Matrix rotation;
  if (matrix.rotation_size() != 9 || !can_be_drawn(matrix.x(), matrix.y()) || !can_be_drawn(matrix.z(), 0)) return {};
  for (int i = 0; i < 9; ++i) rotation[static_cast<std::size_t>(i)] = matrix.rotation(i);
  if (!is_rotation(rotation)) return {};
  return transform(robot_frame, camera_frame, {matrix.x(), matrix.y(), matrix.z()}, quaternion_of(rotation),
                   capture_ns);
}

std::optional<std::string> camera_calibration(std::string_view camera_frame, const foresight::CameraMatrix& matrix,
                                              std::uint64_t capture_ns) {
  const double fx = matrix.focal_x(), fy = matrix.focal_y(), cx = matrix.centre_x(), cy = matrix.centre_y();
  if (!(fx > 0 && fy > 0) || !std::isfinite(fx + fy + cx + cy) || matrix.width() == 0 || matrix.height() == 0)
    return {};
  const std::array<double, 9> k{fx, 0, cx, 0, fy, cy, 0, 0, 1}, identity{1, 0, 0, 0, 1, 0, 0, 0, 1};
  const std::array<double, 12> projection{fx, 0, cx, 0, 0, fy, cy, 0, 0, 0, 1, 0};
  return Wire()
      .message(1, timestamp(capture_ns))
      .fixed(2, matrix.width())
      .fixed(3, matrix.height())
      .numbers(6, k)
      .numbers(7, identity)
      .numbers(8, projection)
      .text(9, camera_frame)
      .bytes();
}

}  // namespace robot::net
