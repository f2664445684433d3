#include "robot/app/truth/simulated_scene.h"

#include <cmath>
#include <numbers>

namespace robot::app {
namespace {

constexpr double kRobotStride = 0.05;  // [m] between the feet of a walking robot, at most
constexpr double kPersonStride = 0.3;  // [m] likewise
constexpr double kPersonSpeed = 0.5;   // [m/s] of the referee behind the touch line
constexpr double kPersonWay = 2;       // [m] to each side of the halfway line
constexpr double kBesideLine = 0.5;    // [m] from the touch line to the referee

truth::SceneRobot robot_of(const sim::Body& body) {
  const double steps = 2 * std::numbers::pi * body.walked / (4 * kRobotStride);
  return {.x = body.position.x,
          .y = body.position.y,
          .heading = body.heading,
          .fallen = sim::lies(body),
          .stride = kRobotStride * std::sin(steps)};
}

/// Returns a person who walks to and fro.
truth::ScenePerson referee_at(double seconds, double width) {
  const double phase = std::fmod(seconds * kPersonSpeed, 4 * kPersonWay);
  const bool there = phase < 2 * kPersonWay;
  return {.x = there ? phase - kPersonWay : 3 * kPersonWay - phase,
          .y = width / 2 + kBesideLine,
          .heading = there ? 0 : std::numbers::pi,
          .stride = kPersonStride * std::sin(2 * std::numbers::pi * phase / (4 * kPersonStride))};
}

}  // namespace

truth::Scene scene_of(const sim::World& world, double ball_radius, double width) {
  truth::Scene scene;
  sim::for_each_robot(world.players, [&](int robot) {
    const sim::Body& body = world.bodies[robot];
    if (body.doing != sim::Body::Doing::removed) scene.robots.push_back(robot_of(body));
  });
  scene.ball =
      truth::SceneBall{.x = world.ball.position.x, .y = world.ball.position.y, .z = ball_radius, .radius = ball_radius};
  if (sim::is_there(world.official))
    scene.people.push_back({.x = world.official.position.x,
                            .y = world.official.position.y,
                            .heading = std::atan2(world.official.velocity.y, world.official.velocity.x)});
  else
    scene.people.push_back(referee_at(world.tick * double{sim::kTickDuration}, width));
  return scene;
}

}  // namespace robot::app
