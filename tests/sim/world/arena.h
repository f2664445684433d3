// Fields, models and worlds for tests of sim/world.
#pragma once

#include <random>

#include "sim/world/contact.h"

namespace sim::arena {

inline constexpr field::Field kField{9, 6, 0.7f, 0.05f, 0.75f, 0.6f, 2.2f, 1.65f, 4, 1.3f, 1.6f, 0.5f, 0.05f};
inline constexpr BallModel kBall{
    .radius = 0.05f, .deceleration = 0.3f, .post_restitution = 0.4f, .robot_restitution = 0.4f, .stop_speed = 0.01f};
inline constexpr ContactModel kContact{.robot_radius = 0.16f,
                                       .foot_radius = 0.1f,
                                       .squatting_radius = 0.22f,
                                       .lying_radius = 0.25f,
                                       .official_radius = 0.2f,
                                       .push_deviation = 0.52f};
inline constexpr Effects kIdeal{};
inline constexpr Effects kNoisyPush{.push_noise = true};

/// [m] from a body's middle to the middle of a ball that touches it
inline constexpr float kReach = kContact.foot_radius + kBall.radius;

/// Returns a world with `players` a side, all removed, and the ball at rest in the middle.
inline World empty(int players = 7) {
  World world;
  world.players = players;
  for (Body& body : world.bodies) body.doing = Body::Doing::removed;
  return world;
}

/// Makes the robot stand there, facing `heading` [rad].
inline Body& stand(World& world, int robot, Vec2 position, float heading = 0) {
  Body& body = world.bodies[robot];
  body.position = position;
  body.heading = heading;
  body.facing = direction(heading);
  body.doing = Body::Doing::standing;
  return body;
}

/// Makes the robot walk from there with `velocity` [m/s, robot].
inline Body& walk(World& world, int robot, Vec2 position, float heading, Vec2 velocity) {
  Body& body = stand(world, robot, position, heading);
  body.doing = Body::Doing::walking;
  body.velocity = velocity;
  return body;
}

/// Puts robots of both sides at random in a square of `size` [m] around `middle`: some walk, some lie, some are removed.
inline World crowd(std::mt19937& random, Vec2 middle, float size) {
  std::uniform_real_distribution<float> metres(-size / 2, size / 2), radians(-kPi, kPi), speed(-0.2f, 0.3f);
  World world = empty();
  for_each_robot(world.players, [&](int robot) {
    const float x = metres(random), y = metres(random), heading = radians(random), forward = speed(random);
    Body& body = walk(world, robot, {middle.x + x, middle.y + y}, heading, {forward, 0});
    if (random() % 8 == 0) body.doing = Body::Doing::removed;
    if (random() % 8 == 0) body.doing = Body::Doing::fallen;
    if (body.doing == Body::Doing::fallen) body.velocity = {};
  });
  return world;
}

inline Vec2 mirrored(Vec2 a) { return {a.x, -a.y}; }

/// Returns the world with left and right exchanged.
inline World mirrored(World world) {
  for (Vec2* place : {&world.ball.position, &world.ball.velocity, &world.ball.acceleration, &world.official.position,
                      &world.official.velocity})
    *place = mirrored(*place);
  for (Vec2& past : world.ball.past) past = mirrored(past);
  for (Body& body : world.bodies) {
    body.position = mirrored(body.position);
    body.heading = -body.heading;
    body.facing = mirrored(body.facing);
    body.velocity = mirrored(body.velocity);
  }
  return world;
}

/// Returns the world with its bodies reordered: the new body i is the old body order[i].
inline World reordered(const World& world, const int (&order)[kMaxRobots]) {
  World result = world;
  for (int i = 0; i < kMaxRobots; ++i) result.bodies[i] = world.bodies[order[i]];
  return result;
}

inline void shuffle(std::mt19937& random, int (&order)[kMaxRobots]) {
  for (int i = 0; i < kMaxRobots; ++i) order[i] = i;
  for (int i = kMaxRobots - 1; i > 0; --i) std::swap(order[i], order[random() % static_cast<unsigned>(i + 1)]);
}

}  // namespace sim::arena
