#include "robot/lab/synthetic_messages.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace robot::lab::synthetic {
namespace {

constexpr double kBallPixelMargin = 4;  // [px]
constexpr double kBallFar = 6;          // [m] beyond that vision does not find it
constexpr double kFriction = 0.4;       // [m/s²] the filter's own
constexpr double kKickReach = 0.28;     // [m]

float narrow(double value) { return static_cast<float>(value); }

std::uint64_t ns(const Moment& moment, double t) {
  return moment.epoch_ns + static_cast<std::uint64_t>(std::llround(t * 1e9));
}

/// The camera of time `t` in the frame `field`.
Camera field_camera(double t, int width, int height) {
  const Walker walker = walker_at(t);
  return moved(camera_in_robot(bearing_at(t), width, height), walker.position, walker.heading);
}

/// Where it is in the robot's frame, as what all percepts have in common.
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
      // as seen from the field the left post of the goal at +x has the greater y
      seen.set_side((side > 0) == (x > 0) ? pb::VisualGoalPost::SIDE_LEFT : pb::VisualGoalPost::SIDE_RIGHT);
      seen.set_colour("white");
    }
  }
}

pb::GameState::State state_at(double t) {
  if (t < kReady) return pb::GameState::STATE_INITIAL;
  if (t < kSet) return pb::GameState::STATE_READY;
  if (t < kPlaying) return pb::GameState::STATE_SET;
  if (t < kGoal) return pb::GameState::STATE_PLAYING;
  return t < kSetAgain ? pb::GameState::STATE_READY : pb::GameState::STATE_SET;
}

void fill_team(std::uint32_t number, pb::TeamState::Colour colour, std::uint32_t score, double t, pb::TeamState& team) {
  team.set_number(number);
  team.set_field_colour(colour);
  team.set_goalkeeper_colour(number == 14 ? pb::TeamState::COLOUR_YELLOW : pb::TeamState::COLOUR_BLACK);
  team.set_goalkeeper(1);
  team.set_score(score);
  team.set_message_budget(1200 - static_cast<std::uint32_t>(std::clamp(t - kReady, 0.0, 1000.0)));
  for (int player = 1; player <= 3; ++player) team.add_players();
}

/// One comparison on the way through the tree.
bool ask(pb::DecisionTrace& trace, const std::string& name, const std::string& condition, const std::string& feature,
         std::optional<double> value, double threshold, bool result) {
  pb::DecisionTrace::Node& node = *trace.add_visited();
  node.set_kind(pb::DecisionTrace::Node::KIND_CONDITION);
  node.set_name(name);
  node.set_path("play/" + name);
  node.set_condition(condition);
  node.set_feature(feature);
  if (value) node.set_value(narrow(*value));
  node.set_threshold(narrow(threshold));
  node.set_result(result);
  return result;
}

void choose(pb::DecisionTrace& trace, const std::string& skill) {
  pb::DecisionTrace::Node& node = *trace.add_visited();
  node.set_kind(pb::DecisionTrace::Node::KIND_SKILL);
  node.set_name(skill);
  node.set_path("play/" + skill);
  node.set_result(true);
  trace.set_skill(skill);
}

}  // namespace

bool ball_visible(double t, int width, int height) {
  const auto ball = ball_at(t);
  if (!ball) return false;
  const Camera camera = field_camera(t, width, height);
  const auto pixel = camera.project({ball->position.x, ball->position.y, kBallRadius});
  return pixel && pixel->depth < kBallFar && camera.shows(*pixel, kBallPixelMargin);
}

pb::CameraMatrix camera_matrix_of(const Moment& moment) {
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

pb::Image image_of(const Moment& moment) {
  pb::Image image;
  image.set_encoding(pb::Image::ENCODING_YUYV);
  image.set_width(static_cast<std::uint32_t>(moment.width));
  image.set_height(static_cast<std::uint32_t>(moment.height));
  image.set_data(draw(field_camera(moment.t, moment.width, moment.height), moment.t));
  return image;
}

pb::Vision vision_of(const Moment& moment, const Sight& sight, const Noise& noise) {
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

std::optional<pb::Ball> ball_of(const Moment& moment, const Sight& sight, const Noise& noise) {
  if (!sight.last_seen) return std::nullopt;
  const Walker walker = walker_at(moment.t), then = walker_at(*sight.last_seen);
  const RollingBall seen = *ball_at(*sight.last_seen);
  const double age = moment.t - *sight.last_seen;
  const double range = std::hypot(seen.position.x - then.position.x, seen.position.y - then.position.y);

  // where the filter let it roll since it was seen, with the error of that image
  const double speed = std::hypot(seen.velocity.x, seen.velocity.y), rolling = std::min(age, speed / kFriction);
  const double way = speed > 0 ? rolling - kFriction * rolling * rolling / (2 * speed) : 0;
  const double slowed = speed > 0 ? std::max(0.0, 1 - kFriction * age / speed) : 0;
  const auto step = static_cast<std::uint64_t>(std::llround(*sight.last_seen * 100));
  const double error = 0.01 + 0.03 * range;
  const Point believed{seen.position.x + way * seen.velocity.x + error * noise(Noise::kBallX, step),
                       seen.position.y + way * seen.velocity.y + error * noise(Noise::kBallY, step)};

  const Point place = relative(believed, walker.position, walker.heading);
  const Point velocity = relative({slowed * seen.velocity.x, slowed * seen.velocity.y}, {}, walker.heading);
  pb::Ball ball;
  ball.set_seen_ns(ns(moment, *sight.last_seen));
  ball.set_x(narrow(place.x));
  ball.set_y(narrow(place.y));
  ball.set_velocity_x(narrow(velocity.x));
  ball.set_velocity_y(narrow(velocity.y));
  ball.set_deviation(narrow(error + 0.05 * age));
  ball.set_visible(sight.visible);
  ball.set_velocity_deviation(narrow(0.05 + 0.1 * age));
  ball.set_stationary(slowed * speed < 0.05);
  const double left = slowed * speed / (2 * kFriction);  // [s] times velocity: where it will rest
  ball.set_rest_x(narrow(place.x + left * velocity.x));
  ball.set_rest_y(narrow(place.y + left * velocity.y));
  ball.set_frames_visible(sight.visible ? sight.run : 0);
  ball.set_frames_missing(sight.visible ? 0 : sight.run);
  return ball;
}

pb::Pose pose_of(const Moment& moment, const Noise& noise) {
  // lost at first, found within seconds, never perfect
  const double lost = std::exp(-moment.t / 1.5), deviation = 0.08 + 0.5 * lost;
  const double drift_x = 0.05 * std::sin(0.5 * moment.t), drift_y = 0.05 * std::cos(0.37 * moment.t);
  const Walker walker = walker_at(moment.t);
  const auto jitter = [&](Noise::Stream stream) { return noise(stream, moment.step); };
  pb::Pose pose;
  pose.set_x(narrow(walker.position.x + drift_x + 0.4 * lost + 0.008 * jitter(Noise::kPoseX)));
  pose.set_y(narrow(walker.position.y + drift_y - 0.3 * lost + 0.008 * jitter(Noise::kPoseY)));
  pose.set_heading(narrow(
      normalised(walker.heading + 0.03 * std::sin(0.6 * moment.t) + 0.3 * lost + 0.01 * jitter(Noise::kPoseHeading))));
  pose.set_deviation_x(narrow(deviation));
  pose.set_deviation_y(narrow(0.8 * deviation));
  pose.set_deviation_heading(narrow(0.05 + 0.4 * lost));
  constexpr std::uint64_t kParticles = 30;
  for (std::uint64_t i = 0; i < kParticles; ++i) {
    const auto off = [&](std::uint64_t axis) {
      return noise(Noise::kParticles, 3 * (kParticles * moment.step + i) + axis);
    };
    pb::Pose::Particle& particle = *pose.add_particles();
    particle.set_x(narrow(pose.x() + deviation * off(0)));
    particle.set_y(narrow(pose.y() + 0.8 * deviation * off(1)));
    particle.set_heading(narrow(normalised(pose.heading() + (0.05 + 0.4 * lost) * off(2))));
    particle.set_weight(1.0f / kParticles);
  }
  return pose;
}

pb::Team team_of(const Moment& moment) {
  pb::Team team;
  const auto ball = ball_at(moment.t);
  for (const OtherRobot& robot : others_at(moment.t)) {
    if (robot.team != 14) continue;
    pb::Teammate& mate = *team.add_teammates();
    mate.set_player(static_cast<std::uint32_t>(robot.player));
    mate.set_role(robot.player == 1 ? "keeper" : "supporter");
    mate.mutable_pose()->set_x(narrow(robot.position.x));
    mate.mutable_pose()->set_y(narrow(robot.position.y));
    mate.mutable_pose()->set_heading(narrow(robot.heading));
    mate.mutable_pose()->set_deviation_x(0.1f);
    mate.mutable_pose()->set_deviation_y(0.1f);
    mate.mutable_pose()->set_deviation_heading(0.08f);
    mate.set_sent_ns(ns(moment, moment.t));
    mate.set_received_ns(ns(moment, moment.t));
    mate.set_active(true);
    if (!ball) continue;
    const Point seen = relative(ball->position, robot.position, robot.heading);
    mate.mutable_ball()->set_seen_ns(ns(moment, moment.t));
    mate.mutable_ball()->set_x(narrow(seen.x));
    mate.mutable_ball()->set_y(narrow(seen.y));
    mate.mutable_ball()->set_deviation(narrow(0.05 + 0.05 * std::hypot(seen.x, seen.y)));
    mate.set_time_to_ball(narrow(std::hypot(seen.x, seen.y) / 0.25));
  }
  if (ball) {
    pb::SharedBall& shared = *team.mutable_shared_ball();
    shared.set_seen_ns(ns(moment, moment.t));
    shared.set_x(narrow(ball->position.x + 0.05 * std::sin(moment.t)));
    shared.set_y(narrow(ball->position.y + 0.05 * std::cos(moment.t)));
    shared.set_deviation(0.15f);
    for (const std::uint32_t player : {1u, 2u, 3u}) shared.add_players(player);
  }
  team.set_sent_ns(ns(moment, moment.t));
  team.set_messages_sent(static_cast<std::uint32_t>(moment.t));
  return team;
}

pb::GameState game_of(const Moment& moment) {
  const double t = moment.t;
  const bool scored = t >= kGoal;
  pb::GameState game;
  game.set_source(pb::GameState::SOURCE_GAME_CONTROLLER);
  game.set_packet_version(18);
  game.set_packet_number(static_cast<std::uint32_t>(2 * t) % 256);
  game.set_received_ns(ns(moment, t));
  game.set_own_team(14);
  game.set_own_player(2);
  game.set_state(state_at(t));
  game.set_phase(pb::GameState::PHASE_NORMAL);
  game.set_half(1);
  game.set_seconds_remaining(narrow(600 - std::clamp(t - kPlaying, 0.0, kGoal - kPlaying)));
  const double ready_since = scored ? kGoal : kReady;
  if (game.state() == pb::GameState::STATE_READY) game.set_secondary_seconds(narrow(45 - (t - ready_since)));
  game.set_kicking_team(scored ? 5 : 14);
  game.set_players_per_team(3);
  game.set_attacks_positive_x(true);
  fill_team(14, pb::TeamState::COLOUR_RED, scored ? 1 : 0, t, *game.mutable_own());
  fill_team(5, pb::TeamState::COLOUR_BLUE, 0, t, *game.mutable_opponent());
  return game;
}

pb::DecisionTrace decision_of(const Moment& moment, const std::optional<pb::Ball>& ball) {
  pb::DecisionTrace trace;
  trace.set_strategy("synthetic");
  trace.set_role("striker");
  trace.set_decide_ns(180'000 + moment.step % 7 * 4'000);
  pb::DecisionTrace::Node& root = *trace.add_visited();
  root.set_kind(pb::DecisionTrace::Node::KIND_SELECTOR);
  root.set_name("play");
  root.set_path("play");
  root.set_result(true);

  const int state = state_at(moment.t);
  if (!ask(trace, "is_playing", "game_state = 5", "game_state", state, 5, state == pb::GameState::STATE_PLAYING)) {
    choose(trace, state == pb::GameState::STATE_READY ? "walk_to_position" : "stand");
    return trace;
  }
  const auto age =
      ball ? std::optional(moment.t - static_cast<double>(ball->seen_ns() - moment.epoch_ns) * 1e-9) : std::nullopt;
  if (!ask(trace, "knows_ball", "ball_age < 3", "ball_age", age, 3, age && *age < 3)) {
    choose(trace, "search_ball");
    return trace;
  }
  const double distance = std::hypot(ball->x(), ball->y());
  const bool near = distance < kKickReach && ball->x() > 0;
  ask(trace, "ball_at_foot", "ball_distance < 0.28", "ball_distance", distance, kKickReach, near);
  choose(trace, near ? "kick" : "approach_ball");
  pb::DecisionTrace::Argument& argument = *trace.add_arguments();
  argument.set_name(near ? "direction" : "distance");
  argument.set_value(narrow(near ? 0.09 : distance));
  return trace;
}

pb::MotionCommand motion_command_of(const Moment& moment) {
  const Walker walker = walker_at(moment.t);
  const Bearing bearing = bearing_at(moment.t);
  pb::MotionCommand command;
  if (std::abs(moment.t - kKick) < 0.2) {
    command.mutable_kick()->set_type("walk_forward");
    command.mutable_kick()->set_leg(pb::Kick::LEG_RIGHT);
    command.mutable_kick()->set_in_walk(true);
    command.mutable_kick()->set_direction(0.09f);
  } else if (walker.speed > 0) {
    command.mutable_walk_speed()->set_x(narrow(walker.speed));
    command.mutable_walk_speed()->set_turn_rate(narrow(walker.turn_rate));
  } else {
    command.set_posture(pb::MotionCommand::POSTURE_STAND);
  }
  command.mutable_head_angles()->set_yaw(narrow(bearing.head_yaw));
  command.mutable_head_angles()->set_pitch(narrow(bearing.head_pitch));
  return command;
}

pb::GroundTruth truth_of(const Moment& moment) {
  pb::GroundTruth truth;
  if (const auto ball = ball_at(moment.t)) {
    truth.mutable_ball()->set_x(narrow(ball->position.x));
    truth.mutable_ball()->set_y(narrow(ball->position.y));
    truth.mutable_ball()->set_velocity_x(narrow(ball->velocity.x));
    truth.mutable_ball()->set_velocity_y(narrow(ball->velocity.y));
  }
  const auto add = [&](int team, int player, Point position, double heading) {
    pb::GroundTruth::TrueRobot& robot = *truth.add_robots();
    robot.set_team(static_cast<std::uint32_t>(team));
    robot.set_player(static_cast<std::uint32_t>(player));
    robot.set_x(narrow(position.x));
    robot.set_y(narrow(position.y));
    robot.set_heading(narrow(heading));
    robot.set_fallen(false);
  };
  const Walker walker = walker_at(moment.t);
  add(14, 2, walker.position, walker.heading);
  for (const OtherRobot& other : others_at(moment.t)) add(other.team, other.player, other.position, other.heading);
  return truth;
}

}  // namespace robot::lab::synthetic
