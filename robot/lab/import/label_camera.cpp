#include "robot/lab/import/label_camera.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "robot/fit/math/least_squares.h"

namespace robot::lab::labels {
namespace {

using fit::LeastSquares, fit::Solution, fit::Vector;

constexpr double kHead = 0.54;     // [m] top of the box of a standing robot; includes the box's margin
constexpr double kEdge = 5;        // [px] a box nearer to the left or right edge may be cut
constexpr double kUpright = 1.15;  // least height / width
constexpr std::size_t kFrameStride = 10;
constexpr std::size_t kFewestBoxes = 50;
constexpr std::size_t kCoarseBoxes = 400;                    // for the choice among the starts
constexpr double kDeviationShare = 0.03, kDeviation = 0.05;  // [m] deviation of a difference at a distance
constexpr double kMostDeviations = 6;
constexpr double kWeight = 10;  // of all boxes together, against what is known of such cameras

/// Undoes the stretch of a wide picture. `side`: half the size of the image, `edge`: the factor at its edge.
double unstretched(double offset, double side, double edge) {
  return offset * (1.25 + std::abs(offset) / side * (edge - 1.25));
}

Camera camera_of(const Vector& parameters, bool super_view) {
  return {.focal_px = parameters[0],
          .height = parameters[1],
          .pitch = parameters[2],
          .roll = parameters[3],
          .lens = parameters[4],
          .super_view = super_view};
}

/// Returns how much farther the head seems than the feet [m], and the distance of the feet.
std::pair<double, double> difference_of(const Camera& camera, const Box& box) {
  const double feet = camera.distance_at(box.middle(), box.bottom);
  return {camera.distance_at(box.middle(), box.top, kHead) - feet, feet};
}

/// The problem of the fit. Its residuals: the differences in deviations, then what is known of such cameras.
LeastSquares problem_of(const std::vector<Box>& boxes, bool super_view) {
  return {.least = {500, 1, 0.02, -0.2, 0},
          .most = {1600, 7, 1.2, 0.2, 3},
          .residuals = [&boxes, super_view](const Vector& parameters, Vector& residuals) {
            const Camera camera = camera_of(parameters, super_view);
            const double weight = kWeight / std::sqrt(static_cast<double>(boxes.size()));
            residuals.clear();
            for (const Box& box : boxes) {
              const auto [difference, feet] = difference_of(camera, box);
              const double deviations = difference / (kDeviationShare * feet + kDeviation);
              residuals.push_back(weight * std::clamp(deviations, -kMostDeviations, kMostDeviations));
            }
            residuals.push_back((camera.focal_px - 920) / 150);
            residuals.push_back(camera.roll / 0.05);
            residuals.push_back((camera.lens - 1) / 0.5);
          }};
}

std::vector<Box> thinned(const std::vector<Box>& boxes, std::size_t most) {
  const std::size_t stride = (boxes.size() + most - 1) / most;
  std::vector<Box> some;
  for (std::size_t i = 0; i < boxes.size(); i += stride) some.push_back(boxes[i]);
  return some;
}

/// Returns the best of several starts, with few boxes.
Vector coarse_fit(const std::vector<Box>& boxes, bool super_view) {
  const LeastSquares problem = problem_of(boxes, super_view);
  Solution best{.parameters = {}, .cost = std::numeric_limits<double>::infinity()};
  for (const double focal_px : {750., 920., 1100.})
    for (const double pitch : {0.3, 0.5, 0.7}) {
      Solution one = minimise(problem, {focal_px, 2.3, pitch, 0, 1});
      if (one.cost < best.cost || best.parameters.empty()) best = std::move(one);
    }
  return best.parameters;
}

}  // namespace

Ground Camera::at(double x_px, double y_px, double above) const {
  double right = x_px - kWidth / 2, down = y_px - kHeight / 2;
  if (super_view) right = unstretched(right, kWidth / 2, 1), down = unstretched(down, kHeight / 2, 4. / 3);
  right /= focal_px, down /= focal_px;
  const double square = right * right + down * down;
  const double scale = 1 + lens * square * (0.18 + square * (0.15 + square * 0.10));

  // the ray in the camera's axes: ahead, left, up; rolled about the first, then pitched
  const double left = -right * scale, up = -down * scale;
  const double y = std::cos(roll) * left - std::sin(roll) * up, rolled_up = std::sin(roll) * left + std::cos(roll) * up;
  const double x = std::cos(pitch) + std::sin(pitch) * rolled_up;
  const double fall = std::sin(pitch) - std::cos(pitch) * rolled_up;
  const double reach = (height - above) / std::max(fall, 1e-3);
  return {.x = x * reach, .y = y * reach};
}

double Camera::distance_at(double x_px, double y_px, double above) const {
  const Ground ground = at(x_px, y_px, above);
  return std::hypot(ground.x, ground.y);
}

std::vector<Box> upright_boxes(const std::vector<Frame>& frames) {
  std::vector<Box> boxes;
  for (std::size_t i = 0; i < frames.size(); i += kFrameStride)
    for (const RobotBox& robot : frames[i].robots)
      if (robot.box.left > kEdge && robot.box.right < kWidth - kEdge &&
          robot.box.height() > kUpright * robot.box.width())
        boxes.push_back(robot.box);
  return boxes;
}

Result<Camera> fit_camera(const std::vector<Box>& upright) {
  if (upright.size() < kFewestBoxes)
    return Error{"the camera: expected at least 50 boxes of upright robots, got " + std::to_string(upright.size())};
  const std::vector<Box> few = thinned(upright, kCoarseBoxes);
  Camera best;
  double least = std::numeric_limits<double>::infinity();
  for (const bool super_view : {true, false}) {
    const Solution fine = minimise(problem_of(upright, super_view), coarse_fit(few, super_view));
    if (fine.cost < least) least = fine.cost, best = camera_of(fine.parameters, super_view);
  }
  return best;
}

CameraError error_of(const Camera& camera, const std::vector<Box>& upright) {
  std::vector<double> shares, metres;
  for (const Box& box : upright) {
    const auto [difference, feet] = difference_of(camera, box);
    metres.push_back(std::abs(difference));
    shares.push_back(std::abs(difference) / std::max(feet, 1e-3));
  }
  return {.share = median(std::move(shares)), .metres = median(std::move(metres))};
}

double median(std::vector<double> values) {
  if (values.empty()) return 0;
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::ranges::nth_element(values, middle);
  return *middle;
}

}  // namespace robot::lab::labels
