// The synthetic robot's perception: its image, its percepts and its belief of the ball.
#include <algorithm>
#include <cmath>
#include <optional>

#include "robot/lab/synthetic/synthetic_messages.h"

namespace robot::lab::synthetic {
namespace {

constexpr double kBallPixelMargin = 4;    // [px]
constexpr double kBallFar = 6;            // [m] greatest distance at which vision finds the ball
constexpr double kAssumedFriction = 0.4;  // [m/s²] in the ball filter

/// Returns the camera at time `t` in the frame `field`.
Camera field_camera(double t, int width, int height) {
  const Walker walker = walker_at(t);
  return moved(camera_in_robot(bearing_at(t), width, height), walker.position, walker.heading);
}

/// Sets the fields that all percepts have in common: the place in the robot's frame.
pb::Detection detection_of(const Camera& camera, const Walker& walker, Point place, double height,
                           const Camera::Pixel& pixel) {
  const Point seen = relative(place, walker.position, walker.heading);
  pb::Detection detection;
  detection.set_camera(pb::Detection::CAMERA_TOP);
  detection.set_image_x(narrow(pixel.u));
  detection.set_image_y(narrow(pixel.v));
  detection.set_angle_x(narrow(std::atan((pixel.u - camera.width / 2.0) / camera.focal)));
  detection.set_angle_y(narrow(std::atan((pixel.v - camera.height / 2.0) / camera.focal)));
  detection.set_x(narrow(seen.x));
  detection.set_y(narrow(seen.y));
  const double distance = std::hypot(seen.x, seen.y);
  detection.set_distance(narrow(distance));
  detection.set_bearing(narrow(std::atan2(seen.y, seen.x)));
  detection.set_elevation(narrow(std::atan2(height - camera.position.z, distance)));
  detection.set_distance_deviation(narrow(0.02 + 0.05 * distance));
  detection.set_bearing_deviation(0.02f);
  detection.set_confidence(narrow(std::clamp(1.1 - distance / 8, 0.1, 1.0)));
  return detection;
}

void set_box(pb::Detection& detection, double left, double top, double width, double height) {
  detection.set_box_left(narrow(left));
  detection.set_box_top(narrow(top));
  detection.set_box_width(narrow(width));
  detection.set_box_height(narrow(height));
}

void add_robots(const Camera& camera, const Walker& walker, double t, pb::Vision& vision) {
  for (const OtherRobot& robot : others_at(t)) {
    const auto [x, y] = robot.position;
    const auto foot = camera.project({x, y, 0}), head = camera.project({x, y, 0.58});
    if (!foot || !head || !camera.shows(*foot, 2) || foot->depth > kBallFar) continue;
    pb::VisualRobot& seen = *vision.add_robots();
    *seen.mutable_detection() = detection_of(camera, walker, robot.position, 0, *foot);
    const double half = camera.focal * 0.13 / foot->depth;
    set_box(*seen.mutable_detection(), foot->u - half, head->v, 2 * half, foot->v - head->v);
    seen.set_side(robot.team == 14 ? pb::VisualRobot::SIDE_OWN : pb::VisualRobot::SIDE_OPPONENT);
    seen.set_jersey(robot.team == 14 ? "red" : "blue");
  }
}

void add_goal_posts(const Camera& camera, const Walker& walker, pb::Vision& vision) {
  for (const double x : {-kFieldLength / 2, kFieldLength / 2}) {
    for (const double side : {-1.0, 1.0}) {
      const Point foot{x, side * (kGoalWidth / 2 + kPostRadius)};
      const auto pixel = camera.project({foot.x, foot.y, 0}), top = camera.project({foot.x, foot.y, kGoalHeight});
      if (!pixel || !top || !camera.shows(*pixel, 2)) continue;
      pb::VisualGoalPost& seen = *vision.add_goal_posts();
      *seen.mutable_detection() = detection_of(camera, walker, foot, 0, *pixel);
      const double half = camera.focal * kPostRadius / pixel->depth;
      set_box(*seen.mutable_detection(), pixel->u - half, top->v, 2 * half, pixel->v - top->v);
      seen.mutable_landmark()->set_id(x > 0 ? "opponent goal" : "own goal");
      // seen from the field, the left post of the goal at +x has the greater y
      seen.set_side((side > 0) == (x > 0) ? pb::VisualGoalPost::SIDE_LEFT : pb::VisualGoalPost::SIDE_RIGHT);
      seen.set_colour("white");
    }
  }
}

}  // namespace

bool ball_visible(double t, int width, int height) {
  const auto ball = ball_at(t);
  if (!ball) return false;
  const Camera camera = field_camera(t, width, height);
  const auto pixel = camera.project({ball->position.x, ball->position.y, kBallRadius});
  return pixel && pixel->depth < kBallFar && camera.shows(*pixel, kBallPixelMargin);
}

pb::CameraMatrix camera_matrix_of(const SyntheticMoment& moment) {
  const Camera camera = camera_in_robot(bearing_at(moment.t), moment.width, moment.height);
  pb::CameraMatrix matrix;
  for (const double number : camera.rotation) matrix.add_rotation(narrow(number));
  matrix.set_x(narrow(camera.position.x));
  matrix.set_y(narrow(camera.position.y));
  matrix.set_z(narrow(camera.position.z));
  matrix.set_width(static_cast<std::uint32_t>(camera.width));
  matrix.set_height(static_cast<std::uint32_t>(camera.height));
  matrix.set_focal_x(narrow(camera.focal));
  matrix.set_focal_y(narrow(camera.focal));
  matrix.set_centre_x(narrow(camera.width / 2.0));
  matrix.set_centre_y(narrow(camera.height / 2.0));
  return matrix;
}

pb::Image image_of(const SyntheticMoment& moment) {
  pb::Image image;
  image.set_encoding(pb::Image::ENCODING_YUYV);
  image.set_width(static_cast<std::uint32_t>(moment.width));
  image.set_height(static_cast<std::uint32_t>(moment.height));
  image.set_data(draw(field_camera(moment.t, moment.width, moment.height), moment.t));
  return image;
}

pb::Vision vision_of(const SyntheticMoment& moment, const Sight& sight, const Noise& noise) {
  const Walker walker = walker_at(moment.t);
  const Camera camera = field_camera(moment.t, moment.width, moment.height);
  pb::Vision vision;
  vision.set_image_width(static_cast<std::uint32_t>(moment.width));
  vision.set_image_height(static_cast<std::uint32_t>(moment.height));
  if (sight.visible) {
    const Point place = ball_at(moment.t)->position;
    auto pixel = *camera.project({place.x, place.y, kBallRadius});
    const double radius = camera.focal * kBallRadius / pixel.depth;
    pixel.u += 0.3 * noise(Noise::kPixel, 2 * moment.step);
    pixel.v += 0.3 * noise(Noise::kPixel, 2 * moment.step + 1);
    pb::Detection& detection = *vision.mutable_ball()->mutable_detection();
    detection = detection_of(camera, walker, place, kBallRadius, pixel);
    set_box(detection, pixel.u - radius, pixel.v - radius, 2 * radius, 2 * radius);
    vision.mutable_ball()->set_radius(narrow(radius));
  }
  add_robots(camera, walker, moment.t, vision);
  add_goal_posts(camera, walker, vision);
  return vision;
}

std::optional<pb::Ball> ball_of(const SyntheticMoment& moment, const Sight& sight, const Noise& noise) {
  if (!sight.last_seen) return std::nullopt;
  const Walker walker = walker_at(moment.t), then = walker_at(*sight.last_seen);
  const RollingBall seen = *ball_at(*sight.last_seen);
  const double age = moment.t - *sight.last_seen;
  const double range = std::hypot(seen.position.x - then.position.x, seen.position.y - then.position.y);

  // the filter's prediction since the last sight, with the error of that image
  const double speed = std::hypot(seen.velocity.x, seen.velocity.y), rolling = std::min(age, speed / kAssumedFriction);
  const double way = speed > 0 ? rolling - kAssumedFriction * rolling * rolling / (2 * speed) : 0;
  const double slowed = speed > 0 ? std::max(0.0, 1 - kAssumedFriction * age / speed) : 0;
  const auto step = static_cast<std::uint64_t>(std::llround(*sight.last_seen * 100));
  const double error = 0.01 + 0.03 * range;
  const Point believed{seen.position.x + way * seen.velocity.x + error * noise(Noise::kBallX, step),
                       seen.position.y + way * seen.velocity.y + error * noise(Noise::kBallY, step)};

  const Point place = relative(believed, walker.position, walker.heading);
  const Point velocity = relative({slowed * seen.velocity.x, slowed * seen.velocity.y}, {}, walker.heading);
  pb::Ball ball;
  ball.set_seen_ns(moment.epoch_ns + step * 10'000'000);
  ball.set_x(narrow(place.x));
  ball.set_y(narrow(place.y));
  ball.set_velocity_x(narrow(velocity.x));
  ball.set_velocity_y(narrow(velocity.y));
  ball.set_deviation(narrow(error + 0.05 * age));
  ball.set_visible(sight.visible);
  ball.set_velocity_deviation(narrow(0.05 + 0.1 * age));
  ball.set_stationary(slowed * speed < 0.05);
  const double left =
      slowed * speed / (2 * kAssumedFriction);  // [s] times the velocity is the way to the place of rest
  ball.set_rest_x(narrow(place.x + left * velocity.x));
  ball.set_rest_y(narrow(place.y + left * velocity.y));
  ball.set_frames_visible(sight.visible ? sight.run : 0);
  ball.set_frames_missing(sight.visible ? 0 : sight.run);
  return ball;
}

}  // namespace robot::lab::synthetic
