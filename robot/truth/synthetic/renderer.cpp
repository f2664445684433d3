#include "robot/truth/synthetic/renderer.h"

#include <algorithm>

#include "robot/truth/synthetic/bodies.h"
#include "robot/truth/synthetic/colours.h"

namespace robot::truth {
namespace {

/// Writes the depths of an exact image, 0 where there is nothing or the depth does not fit.
void measure_exactly(const Cast& cast, double depth_scale, DepthFrame& frame) {
  frame.depth.resize(cast.depth.size());
  const double steps = 1 / (frame.unit * depth_scale);
  std::transform(cast.depth.begin(), cast.depth.end(), frame.depth.begin(), [&](float z) {
    const double measured = static_cast<double>(z) * steps + 0.5;
    return static_cast<std::uint16_t>(measured < 65536 ? measured : 0);
  });
}

}  // namespace

Renderer::Renderer(const SensorPose& pose, const Surroundings& surroundings, RenderOptions options)
    : pose_(pose), options_(options), empty_(cast_of(surroundings, pose)), cast_(empty_) {}

DepthFrame Renderer::render(const Scene& scene, std::uint64_t number) {
  draw_bodies(scene);
  DepthFrame frame;
  frame.intrinsics = pose_.intrinsics;
  if (options_.noise)
    noise_.measure(cast_, pose_.depth_scale, number, frame);
  else
    measure_exactly(cast_, pose_.depth_scale, frame);
  if (options_.colour) paint(cast_, number, frame);
  return frame;
}

void Renderer::draw_bodies(const Scene& scene) {
  bodies_.clear();
  for (const SceneRobot& robot : scene.robots) add(robot, bodies_);
  for (const ScenePerson& person : scene.people) add(person, bodies_);
  if (scene.ball) add(*scene.ball, bodies_);

  cast_ = empty_;  // the vectors keep their memory
  const Eigen::Isometry3f sensor_from_field = pose_.field_from_sensor.inverse().cast<float>();
  for (Capsule& body : bodies_) {
    body.from = sensor_from_field * body.from;
    body.to = sensor_from_field * body.to;
    draw(body, pose_.intrinsics, cast_);
  }
}

}  // namespace robot::truth
