#include "robot/truth/detection/robot_finder.h"

#include <cmath>

namespace robot::truth {
namespace {

using Eigen::Vector2f;
using Eigen::Vector3f;

/// The robots that show themselves in one layer. Distances [m], areas [m²].
struct Kind {
  Layer layer;
  float radius;             // of the part that is looked for
  float least_area;         // of it: a third of the usual one
  float person;             // tall things within this distance belong to the same person
  float claim;              // the layers below within this distance belong to the same robot
  float height;             // of the surface, on average
  float surface_to_centre;  // in a level view
  float along, across;      // standard deviations by its shape, in the direction of the view and square to it
};

/// The view of a sensor on a place.
struct View {
  Vector2f away;    // horizontal unit vector [field] from the sensor
  float level;      // cosine of the angle between ray and ground
  float deviation;  // [m] of a single depth
  float pixel;      // [m²] the area that a pixel covers

  View(const Sight& sight, const Vector3f& place)
      : away((place - sight.eye()).head<2>().normalized()),
        level((place - sight.eye()).head<2>().norm() / (place - sight.eye()).norm()),
        deviation(sight.deviation_at(place)),
        pixel(sight.pixel_area() * sight.depth_of(place) * sight.depth_of(place)) {}
};

Vector3f at_height(const Vector2f& place, float height) { return {place.x(), place.y(), height}; }

/// Reports whether a ball of some radius around a place [m, field] reaches out of the image.
bool at_border(const Sight& sight, const Vector3f& place, float radius) {
  const SensorPose& pose = sight.pose();
  const Eigen::Vector3d seen = pose.field_from_sensor.inverse() * place.cast<double>();
  const double margin_x = pose.intrinsics.focal_x * static_cast<double>(radius) / seen.z();
  const double margin_y = pose.intrinsics.focal_y * static_cast<double>(radius) / seen.z();
  const Eigen::Vector2d pixel = pose.pixel(place.cast<double>());
  return pixel.x() < margin_x || pixel.x() > pose.intrinsics.width - margin_x || pixel.y() < margin_y ||
         pixel.y() > pose.intrinsics.height - margin_y;
}

SeenRobot seen_robot(const View& view, const Kind& kind, const Surface& surface) {
  // blocks of pixels have the same noise, and the highest of some hundred points is two deviations too high
  constexpr float kBlock = 9, kTopNoise = 2;
  const float along = std::hypot(kind.along, view.deviation * std::sqrt(kBlock * view.pixel / surface.area));
  const Vector2f left(-view.away.y(), view.away.x());
  const Vector2f place = surface.mean() + kind.surface_to_centre * view.level * view.away;
  const Eigen::Matrix2f covariance =
      along * along * view.away * view.away.transpose() + kind.across * kind.across * left * left.transpose();
  const float rise = std::sqrt(1 - view.level * view.level);
  SeenRobot robot;
  robot.place = {.position = place.cast<double>(), .covariance = covariance.cast<double>()};
  robot.height = static_cast<double>(surface.top - kTopNoise * rise * view.deviation);
  return robot;
}

/// Returns the surface in the middle of the densest part of a layer.
Surface densest_part(const Kind& kind, const GroundGrid& grid) {
  Surface part = grid.within(kind.layer, grid.densest(kind.layer, kind.radius), kind.radius);
  for (int step = 0; step < 2 && part.area > 0; ++step) {
    const Surface centred = grid.within(kind.layer, part.mean(), kind.radius);
    if (centred.area > 0) part = centred;
  }
  return part;
}

void find_kind(const Sight& sight, const Kind& kind, GroundGrid& grid, std::vector<SeenRobot>& robots) {
  constexpr float kPersonArea = 0.002F;
  constexpr int kMostParts = 64;  // an image of nothing but noise must not take long
  for (int i = 0; i < kMostParts; ++i) {
    const Surface part = densest_part(kind, grid);
    if (part.area < kind.least_area) return;
    const Vector2f place = part.mean();
    const View view(sight, at_height(place, kind.height));
    // the noise spreads a part along the ray
    grid.remove(kind.layer, place, 1.2F * kind.radius + 2 * view.deviation);
    if (grid.within(Layer::tall, place, kind.person + 2 * view.deviation).area > kPersonArea) continue;
    if (!at_border(sight, at_height(place, kind.height), 0.7F * kind.radius))
      robots.push_back(seen_robot(view, kind, part));
    if (kind.layer != Layer::low) grid.remove(Layer::low, place, kind.claim);
    if (kind.layer == Layer::head) grid.remove(Layer::body, place, kind.claim);
  }
}

}  // namespace

void find_robots(const Sight& sight, const DetectorOptions& options, GroundGrid& grid, std::vector<SeenRobot>& robots) {
  const auto posture = static_cast<float>(options.posture_deviation), height = static_cast<float>(options.robot_height);
  // sizes, areas and deviations measured on synthetic robots like a Nao at random headings and arms (bench_truth)
  const Kind heads{.layer = Layer::head,
                   .radius = 0.10F,
                   .least_area = 0.006F,
                   .person = 0.15F,
                   .claim = 0.28F,
                   .height = 0.87F * height,
                   .surface_to_centre = static_cast<float>(options.surface_to_centre),
                   .along = posture,
                   .across = posture};
  const Kind bodies{.layer = Layer::body,
                    .radius = 0.17F,
                    .least_area = 0.020F,
                    .person = 0.35F,
                    .claim = 0.28F,
                    .height = 0.55F * height,
                    .surface_to_centre = 0.07F,
                    .along = 0.02F,
                    .across = 0.035F};
  const Kind lying{.layer = Layer::low,
                   .radius = 0.28F,
                   .least_area = 0.025F,
                   .person = 0.45F,
                   .claim = 0,
                   .height = 0.1F,
                   .surface_to_centre = 0.09F,
                   .along = 0.034F,
                   .across = 0.045F};
  for (const Kind& kind : {heads, bodies, lying}) find_kind(sight, kind, grid, robots);
}

}  // namespace robot::truth
