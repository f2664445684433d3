#include "tests/bench/truth_calibration.h"

#include <Eigen/LU>
#include <algorithm>
#include <cstdio>
#include <ctime>
#include <numeric>
#include <vector>

#include "robot/truth/calibration/view.h"
#include "tests/support/ground_picture.h"

namespace bench {
namespace {

using namespace robot::truth;

constexpr double kInside95 = 5.991;  // squared radius of the 95 % ellipse of two normal coordinates

/// The errors of one kind of measurement.
class Errors {
 public:
  Errors(MeasuredBy measurement, double height) : measurement_(measurement), height_(height) {}

  void add(const tests::GroundScene& scene, const Calibration& calibration) {
    for (double x = -1.5; x < 1.6; x += 0.75)
      for (double y = -1.5; y < 1.6; y += 0.75) add_point(scene, calibration, {x, y, height_});
  }

  void print(const char* name) {
    std::sort(centimetres_.begin(), centimetres_.end());
    const auto count = static_cast<double>(centimetres_.size());
    const double mean = std::accumulate(centimetres_.begin(), centimetres_.end(), 0.) / count;
    std::printf(R"("%s": {"mean_cm": %.2f, "p95_cm": %.2f, "coverage": %.3f}, )", name, mean,
                centimetres_[centimetres_.size() * 95 / 100], inside_ / count);
  }

 private:
  void add_point(const tests::GroundScene& scene, const Calibration& calibration, const Eigen::Vector3d& point) {
    const View view{calibration.pose.field_from_sensor,
                    calibration.pose.depth_scale,
                    {calibration.pose.intrinsics, calibration.lens}};
    ViewCovariance covariance = ViewCovariance::Zero();
    covariance.topLeftCorner<7, 7>() = calibration.pose.covariance;

    const Eigen::Vector2d pixel = scene.pose().pixel(point);
    const double depth = (scene.field_from_sensor.inverse() * point).z() / scene.depth_scale;
    const auto measured =
        measurement_ == MeasuredBy::depth ? view.point(pixel, depth) : view.point_at_height(pixel, height_);
    const auto spread = place_covariance(view, covariance, point, measurement_);
    if (!measured || !spread) return;
    const Eigen::Vector2d error = (*measured - point).head<2>();
    centimetres_.push_back(100 * error.norm());
    inside_ += error.dot(spread->inverse() * error) < kInside95 ? 1 : 0;
  }

  MeasuredBy measurement_;
  double height_;  // [m]
  double inside_ = 0;
  std::vector<double> centimetres_;
};

double processor_seconds() { return static_cast<double>(std::clock()) / CLOCKS_PER_SEC; }

}  // namespace

void calibration_trials(int trials, double click_deviation, double scale) {
  tests::GroundScene scene = tests::mast_scene();
  scene.depth_scale = 1 / scale;
  const auto landmarks = landmarks_of(scene.field);
  const CalibrationOptions options{.click_deviation = click_deviation};
  Errors robots(MeasuredBy::depth, options.robot_height), ball(MeasuredBy::bearing, options.ball_radius);
  std::mt19937 random(1);
  int refused = 0;
  std::size_t clicked = 0;
  double seconds = 0;
  for (int trial = 0; trial < trials; ++trial) {
    const auto frame = scene.depth_image(&random);
    const auto clicks = scene.clicks(random, click_deviation);
    const double begin = processor_seconds();
    const auto calibration = calibrate(landmarks, clicks, frame, options);
    seconds += processor_seconds() - begin;
    clicked = clicks.size();
    if (!calibration || !calibration->refused.empty()) {
      ++refused;
      continue;
    }
    robots.add(scene, *calibration);
    ball.add(scene, *calibration);
  }
  std::printf(R"({"click_px": %.1f, "scale": %.3f, "trials": %d, "landmarks": %zu, "refused": %d, )", click_deviation,
              scale, trials, clicked, refused);
  if (refused < trials) robots.print("robots"), ball.print("ball");
  std::printf(R"("calibration_ms": %.1f})"
              "\n",
              1000 * seconds / trials);
}

}  // namespace bench
