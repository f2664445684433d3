// A world with the bodies of a match, which tests move step by step.
#pragma once

#include "sim/motion/motion.h"

namespace sim::motion {

inline Model match_model() {
  Model model{};
  model.walk = {.forward = 0.25f,
                .backward = 0.2f,
                .sideward = 0.18f,
                .turn_rate = 1.222f,
                .acceleration = 0.6f,
                .turn_acceleration = 4,
                .turn_cost = 0.73f,
                .slow_down = 0.1f,
                .step_duration = 0.25f,
                .spread = 0.4f,
                .speed_noise = 0.15f,
                .turn_noise = 0.1f,
                .start_delay = 0.25f,
                .stop_delay = 0.5f};
  model.head = {.yaw_limit = 2, .pitch_up = -0.672f, .pitch_down = 0.515f, .yaw_speed = 4, .pitch_speed = 1.5f};
  model.kick_count = 3;
  model.kicks[0] = {"forward", 0.185f, 0.05f, 0.04f, 0.03f, 0.65f, 1.65f, 3, 0.22f, 0, 0.122f};
  model.kicks[1] = {"side", 0.06f, 0.18f, 0.04f, 0.04f, 0.25f, 0.5f, 1.4f, 0.22f, 1.571f, 0.122f};
  model.kicks[2] = {"turn", 0.18f, 0.08f, 0.04f, 0.03f, 0.25f, 0.5f, 1, 0.07f, 0.785f, 0.122f};
  model.hits = {.partial = 0.6f, .spread = 2};
  model.falls = {.per_minute_walking = 6, .per_second_touching = 0.5f, .lying = 1, .getting_up = 2, .failure = 0.25f};
  return model;
}

/// All effects of motion except falls.
inline Effects all_effects() {
  Effects effects{};
  effects.walk_acceleration = effects.walk_noise = effects.walk_delay = true;
  effects.head_limits = effects.kick_noise = effects.kick_whiff = true;
  return effects;
}

inline Effects no_noise() {
  Effects effects = all_effects();
  effects.walk_noise = effects.kick_noise = false;
  return effects;
}

struct Arena {
  Model model = match_model();
  Effects effects = all_effects();
  BallModel ball{.radius = 0.05f, .deceleration = 0.3f};
  World world{};

  static constexpr int kRobot = 2;
  Body& body() { return world.bodies[kRobot]; }

  /// Moves the body by `steps` ticks and advances the world by as many.
  void move(const Command& command, Tick steps = 1) {
    world.kicked = world.touched = world.whiffed = kNobody;
    const MotionParams params{model, effects, ball};
    const Pose2 told{body().position, body().heading};
    const Mover mover{&command, &told, &world, kRobot, steps, steps};
    motion::move(params, {&mover, 1});
    world.tick += steps;
  }
};

inline Command walk_speed(Vec2 velocity, float turn) {
  Command command;
  command.body = Command::Body::walk_speed;
  command.walk = velocity;
  command.turn = turn;
  return command;
}

/// Returns the command that walks to a pose of the field.
inline Command walk_to(const Body& body, Pose2 target) {
  Command command;
  command.body = Command::Body::walk_to;
  command.walk = turned_back(target.position - body.position, body.facing);
  command.turn = normalized(target.heading - body.heading);
  return command;
}

}  // namespace sim::motion
