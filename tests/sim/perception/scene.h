// A world and the cognitive controller of a match, which tests move step by step.
#pragma once

#include "sim/perception/perception.h"
#include "tests/sim/support/fields.h"

namespace sim::perception {

inline Model match_model() {
  Model model{};
  model.camera = {.height = 0.45f,
                  .width = 0.983f,
                  .upper_edge = -0.36f,
                  .lower_edge = 1.074f,
                  .pixel_angle = 0.00154f,
                  .latency = 0.07f};
  model.ball = {.near = 0.9f, .far = 0.15f, .near_range = 0.5f, .far_range = 5};
  model.robots = {.near = 0.6f, .far = 0.15f, .near_range = 0.5f, .far_range = 5};
  model.noise = {.pixels = 2, .tilt = 0.02f, .tilt_walking = 0.03f, .roll = 0.02f};
  model.filter = {
      .acceleration_noise = 1, .first_velocity = 0.5f, .reacquire = 5, .lost_deviation = 2, .false_per_second = 0.015f};
  model.localisation = {.start_deviation = 0.3f,
                        .start_deviation_heading = 0.17f,
                        .bias = 0.05f,
                        .translation_noise = 0.1f,
                        .rotation_noise = 0.1f,
                        .rotation_per_metre = 0.05f,
                        .mark_interval = 0.5f,
                        .mark_near = 0.4f,
                        .mark_range = 5,
                        .mark_deviation = 0.08f,
                        .mark_deviation_heading = 0.1f,
                        .flips_per_minute = 0.02f,
                        .flip_duration = 15};
  model.radio = {.delay = 0.1f, .loss = 0.1f};
  return model;
}

inline Effects all_effects() {
  Effects effects{};
  effects.limited_view = effects.missed_ball = effects.occlusion = effects.false_balls = true;
  effects.ball_noise = effects.latency = effects.odometry_drift = effects.pose_flips = true;
  effects.packet_limit = effects.packet_delay = effects.packet_loss = true;
  return effects;
}

/// A world with four robots a side, all but one far away, and the beliefs of that one.
struct Scene {
  static constexpr int kRobot = 1;     // player 2 at home
  static constexpr int kOpponent = 8;  // player 2 away

  Model model = match_model();
  Effects effects = all_effects();
  field::Field field = kField2012;
  field::Marks marks = field::marks_of(field);
  ContactModel contact{.robot_radius = 0.16f,
                       .foot_radius = 0.1f,
                       .lying_radius = 0.3f,
                       .hiding_radius = 0.11f,
                       .official_radius = 0.25f,
                       .push_deviation = 0};
  BallModel ball{.radius = 0.05f, .deceleration = 0.3f};
  World world{};
  agent::Beliefs beliefs;
  Cognition cognition;

  explicit Scene(std::uint64_t seed = 1) {
    world.key = {seed};
    world.players = 4;
    for (int i = 0; i < kMaxRobots; ++i) world.bodies[i].position = {100 + static_cast<float>(i), 100};
    stand({0, 0}, 0);
    place_ball({1, 0});
  }

  PerceptionParams params() const { return {model, effects, field, marks, contact, ball}; }
  Body& body(int robot = kRobot) { return world.bodies[robot]; }

  void stand(Vec2 position, float heading, int robot = kRobot) {
    body(robot).position = position;
    body(robot).heading = heading;
    body(robot).facing = direction(heading);
  }
  void look(float yaw, float pitch) {
    body().head_yaw = yaw;
    body().head_pitch = pitch;
    body().look = direction(yaw);
  }
  void place_ball(Vec2 position) {
    world.ball = {};
    world.ball.position = position;
    for (Vec2& past : world.ball.past) past = position;
  }

  void enter() { perception::enter(params(), world, kRobot, beliefs, cognition); }
  /// Returns a look at the present world.
  Look look_after(Tick steps) { return {&world, &beliefs, &cognition, kRobot, steps}; }
  /// Perceives the present world after this many ticks.
  void perceive(Tick steps = 1) {
    world.tick += steps;
    const Look look = look_after(steps);
    perception::perceive(params(), {&look, 1});
  }

  /// Walks and turns for a tick with these speeds. [m/s, robot], [rad/s]
  void walk(Vec2 velocity, float turn_rate) {
    Body& self = body();
    self.doing = Body::Doing::walking;
    self.velocity = velocity;
    stand(self.position + kTickDuration * turned(velocity, self.facing),
          normalized(self.heading + kTickDuration * turn_rate));
  }
  void roll_ball() { roll(world.ball, ball.deceleration, ball.stop_speed, kTickDuration); }
};

}  // namespace sim::perception
