#include "tests/support/ground_picture.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "robot/truth/synthetic/sensor_poses.h"
#include "tests/sim/support/fields.h"

namespace tests {
namespace {

using robot::truth::DepthFrame;
using robot::truth::DepthNoise;
using robot::truth::Intrinsics;

constexpr double kNowhere = std::numeric_limits<double>::infinity();

/// A ray from the sensor, in plain numbers: a test without optimisation renders 300,000 of them.
struct Ray {
  double eye[3], way[3];  // [m, field] per metre of depth
};

/// Returns the depth at which the ray enters the box, by its slabs.
double entry_of(const Box& box, const Ray& ray) {
  const double least[] = {box.least[0], box.least[1], 0}, most[] = {box.most[0], box.most[1], box.height};
  double from = 0, to = kNowhere;
  for (int i = 0; i < 3; ++i) {
    const double a = (least[i] - ray.eye[i]) / ray.way[i], b = (most[i] - ray.eye[i]) / ray.way[i];
    from = std::max(from, std::min(a, b));
    to = std::min(to, std::max(a, b));
    if (from > to) return kNowhere;
  }
  return from;
}

/// Returns the depth as a sensor of disparities measures it, in steps.
double measured(const Intrinsics& intrinsics, double z, std::mt19937* random) {
  if (!random) return z;
  const double noisy = z + DepthNoise::deviation(z) * normal_number(*random);
  const double pixels = std::round(8 * intrinsics.focal_x * intrinsics.baseline / noisy) / 8;
  return intrinsics.focal_x * intrinsics.baseline / pixels;
}

}  // namespace

double normal_number(std::mt19937& random) {
  const auto uniform = [&] { return (static_cast<double>(random()) + 0.5) / 4294967296.; };
  const double radius = std::sqrt(-2 * std::log(uniform()));
  return radius * std::cos(2 * M_PI * uniform());
}

robot::truth::SensorPose GroundScene::pose() const {
  return {.intrinsics = intrinsics, .field_from_sensor = field_from_sensor, .depth_scale = depth_scale};
}

DepthFrame GroundScene::depth_image(std::mt19937* random) const {
  constexpr double kFarthest = 8;  // [m]
  DepthFrame frame{.intrinsics = intrinsics};
  frame.depth.reserve(static_cast<std::size_t>(intrinsics.width) * static_cast<std::size_t>(intrinsics.height));
  const Eigen::Matrix3d turn = field_from_sensor.linear();
  Ray ray;
  Eigen::Vector3d::Map(ray.eye) = field_from_sensor.translation();
  for (int row = 0; row < intrinsics.height; ++row)
    for (int column = 0; column < intrinsics.width; ++column) {
      const double x = (column + 0.5 - intrinsics.centre_x) / intrinsics.focal_x;
      const double y = (row + 0.5 - intrinsics.centre_y) / intrinsics.focal_y;
      for (int i = 0; i < 3; ++i) ray.way[i] = turn(i, 0) * x + turn(i, 1) * y + turn(i, 2);
      double z = ray.way[2] < 0 ? -ray.eye[2] / ray.way[2] : kNowhere;
      for (const Box& box : boxes) z = std::min(z, entry_of(box, ray));
      const double depth = z < kFarthest ? measured(intrinsics, z, random) / depth_scale : 0;
      frame.depth.push_back(static_cast<std::uint16_t>(std::lround(depth / frame.unit)));
    }
  return frame;
}

std::vector<robot::truth::Click> GroundScene::clicks(std::mt19937& random, double deviation) const {
  std::vector<robot::truth::Click> clicks;
  for (const auto& landmark : robot::truth::landmarks_of(field)) {
    const robot::truth::Projection camera{intrinsics, {}};
    if (!camera.shows(field_from_sensor.inverse() * landmark.position) || landmark.deviation > 0) continue;
    const Eigen::Vector2d pixel = pose().pixel(landmark.position);
    const double x = pixel.x() + deviation * normal_number(random), y = pixel.y() + deviation * normal_number(random);
    clicks.push_back({landmark.name, std::clamp(x, 0., static_cast<double>(intrinsics.width)),
                      std::clamp(y, 0., static_cast<double>(intrinsics.height))});
  }
  return clicks;
}

GroundScene mast_scene() {
  return {.field = sim::kField2012,
          .field_from_sensor = robot::truth::mast(sim::kField2012).field_from_sensor,
          .boxes = {{{-1.1, -0.4}, {-0.8, -0.2}, 0.55},
                    {{0.5, -0.9}, {0.8, -0.7}, 0.55},
                    {{1.0, 0.9}, {1.3, 1.1}, 0.55},
                    {{-0.5, 1.2}, {-0.2, 1.4}, 0.55},
                    {{-2.0, 0.2}, {-1.6, 0.6}, 1.8},
                    {{-5, 2.9}, {5, 3.1}, 3}}};
}

}  // namespace tests
