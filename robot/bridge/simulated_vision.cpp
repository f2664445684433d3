#include "robot/bridge/simulated_vision.h"

#include <algorithm>
#include <cmath>

#include "sim/math/angles.h"
#include "sim/math/random.h"
#include "sim/perception/image.h"

namespace robot::bridge {
namespace {

/// The optical axis of the camera.
struct Axis {
  double yaw, pitch;  // [rad] to the left, downwards
};

Axis axis_of(const SimulatedImage& image, const sim::perception::Camera& camera) {
  return {.yaw = image.head_yaw, .pitch = image.head_pitch + (camera.upper_edge + camera.lower_edge) / 2.};
}

double focal_of(const sim::perception::Camera& camera) { return 1. / std::max(camera.pixel_angle, 1e-4f); }

/// Returns the size of the image [px] that spans an angle.
std::uint32_t size_of(const sim::perception::Camera& camera, double angle) {
  return static_cast<std::uint32_t>(std::lround(2 * focal_of(camera) * std::tan(std::min(angle, 3.) / 2)));
}

std::uint32_t width_of(const sim::perception::Camera& camera) { return size_of(camera, camera.width); }
std::uint32_t height_of(const sim::perception::Camera& camera) {
  return size_of(camera, camera.lower_edge - camera.upper_edge);
}

/// The direction of a line of sight: unit vector in the camera's frame, and its angles in the robot's frame.
struct Sight {
  double bearing, elevation;  // [rad, robot]
  double right, below, ahead;
};

/// Returns the line of sight to a ball at `place` [m, robot], whose middle is `down` [m] below the camera.
Sight sight_of(const Axis& axis, const sim::Vec2& place, double down) {
  const double bearing = std::atan2(place.y, place.x), elevation = -std::atan2(down, sim::length(place));
  const double off = bearing - axis.yaw, flat = std::cos(elevation) * std::cos(off);
  return {.bearing = bearing,
          .elevation = elevation,
          .right = -std::cos(elevation) * std::sin(off),
          .below = -std::sin(elevation) * std::cos(axis.pitch) - flat * std::sin(axis.pitch),
          .ahead = flat * std::cos(axis.pitch) - std::sin(elevation) * std::sin(axis.pitch)};
}

/// Returns the radius [px] of a ball `range` [m] away, seen in this direction: beside the axis it looks larger.
float radius_of(const sim::perception::Camera& camera, float ball_radius, float range, const Sight& sight) {
  const double far = std::max(std::hypot(range, camera.height - ball_radius), 1.01f * ball_radius);
  return static_cast<float>(focal_of(camera) * std::tan(std::asin(ball_radius / far)) / std::max(sight.ahead, 0.1));
}

}  // namespace

SimulatedImage image_of(const sim::Params& params, const sim::World& world, int robot) {
  const sim::Models& own = sim::models_of(params, robot);
  const sim::Models& common = params.teams[0].models;
  const sim::Body& body = world.bodies[robot];
  SimulatedImage image;
  if (!sim::perception::has_eyes(body)) return image;
  image = {.taken = true, .head_yaw = body.head_yaw, .head_pitch = body.head_pitch};
  const sim::perception::PerceptionParams perception{own.perception, own.effects,    params.rules.field,
                                                     params.marks,   common.contact, common.ball};
  image.ball = sim::perception::look_for_ball(perception, world, robot);
  if (!image.ball.seen) return image;
  const sim::perception::Camera& camera = own.perception.camera;
  const float size = common.ball.radius;
  image.ball_radius = radius_of(camera, size, image.ball.range,
                                sight_of(axis_of(image, camera), image.ball.position, camera.height - size));
  if (!own.effects.ball_noise) return image;
  const auto words = sim::draw(world.key, static_cast<std::uint32_t>(robot), sim::Draw::ball_size, world.tick);
  const float error = std::sqrt(0.5f) * own.perception.noise.pixels * sim::normals(words[0], words[1])[0];
  image.ball_radius = std::max(0.5f, image.ball_radius + error);
  return image;
}

void to_proto(const SimulatedImage& image, const sim::perception::Camera& camera, foresight::CameraMatrix& message) {
  const Axis axis = axis_of(image, camera);
  const double sin_yaw = std::sin(axis.yaw), cos_yaw = std::cos(axis.yaw);
  const double sin_pitch = std::sin(axis.pitch), cos_pitch = std::cos(axis.pitch);
  // columns: right, down and forward in the robot's frame
  const double rotation[9] = {sin_yaw,  -sin_pitch * cos_yaw, cos_pitch * cos_yaw,  //
                              -cos_yaw, -sin_pitch * sin_yaw, cos_pitch * sin_yaw,  //
                              0,        -cos_pitch,           -sin_pitch};
  message.clear_rotation();
  for (const double number : rotation) message.add_rotation(static_cast<float>(number));
  message.set_z(camera.height);
  message.set_width(width_of(camera)), message.set_height(height_of(camera));
  message.set_focal_x(static_cast<float>(focal_of(camera))), message.set_focal_y(static_cast<float>(focal_of(camera)));
  message.set_centre_x(static_cast<float>(message.width()) / 2);
  message.set_centre_y(static_cast<float>(message.height()) / 2);
}

void to_proto(const SimulatedImage& image, const sim::Models& models, foresight::Vision& message) {
  const sim::perception::Camera& camera = models.perception.camera;
  message.set_image_width(width_of(camera)), message.set_image_height(height_of(camera));
  message.clear_ball();
  if (!image.ball.seen) return;
  const sim::Vec2 place = image.ball.position;
  const Sight sight = sight_of(axis_of(image, camera), place, camera.height - models.ball.radius);
  foresight::VisualBall& ball = *message.mutable_ball();
  foresight::Detection& detection = *ball.mutable_detection();
  detection.set_camera(foresight::Detection::CAMERA_TOP);
  detection.set_image_x(static_cast<float>(message.image_width() / 2. + focal_of(camera) * sight.right / sight.ahead));
  detection.set_image_y(static_cast<float>(message.image_height() / 2. + focal_of(camera) * sight.below / sight.ahead));
  detection.set_angle_x(static_cast<float>(std::atan2(sight.right, sight.ahead)));
  detection.set_angle_y(static_cast<float>(std::atan2(sight.below, sight.ahead)));
  detection.set_x(place.x), detection.set_y(place.y);
  detection.set_distance(sim::length(place)), detection.set_bearing(static_cast<float>(sight.bearing));
  detection.set_elevation(static_cast<float>(sight.elevation));
  ball.set_radius(image.ball_radius);
  if (models.effects.ball_noise || image.ball.heat > 0) ball.set_heat(image.ball.heat);
}

}  // namespace robot::bridge
