// One robot alone with a ball, for tests of skills.
#pragma once

#include <algorithm>
#include <utility>

#include "sim/motion/motion.h"
#include "sim/world/effects.h"
#include "sim/world/model.h"
#include "tests/sim/agent/scene.h"

namespace sim::agent {

/// One robot with true beliefs, alone with a ball, without noise.
struct Practice {
  Practice(Tree tree, Pose2 pose, Vec2 ball) : behaviour(std::move(tree)) {
    world.ball.position = ball;
    body().position = pose.position;
    body().heading = pose.heading;
    body().facing = direction(pose.heading);
    world.tick = scene.now;
    effects.walk_acceleration = effects.walk_delay = effects.kick_whiff = true;
  }
  Practice(const char* strategy, Pose2 pose, Vec2 ball) : Practice(shipped(strategy), pose, ball) {}
  Body& body() { return world.bodies[1]; }

  /// Plays one tick. Returns true when the foot meets the ball.
  bool step() {
    scene.now = world.tick;
    scene.beliefs.pose.pose = {body().position, body().heading};
    scene.see_ball(turned_back(world.ball.position - body().position, body().facing));
    command = scene.decide(behaviour);
    world.kicked = kNobody;
    const motion::Mover mover{&command, nullptr, &world, 1, 1, 0};
    motion::move({*surroundings().motion, effects, ball_model}, {&mover, 1});
    nearest = std::min(nearest, distance(body().position, world.ball.position));
    ++world.tick;
    return world.kicked != kNobody;
  }

  TreeBehaviour behaviour;
  Scene scene;
  World world;
  Effects effects{};
  BallModel ball_model{.radius = 0.05f, .deceleration = 0.3f};
  motion::Command command;
  float nearest = 100;  // [m] nearest distance to the ball
};

}  // namespace sim::agent
