#include "tests/bench/truth_scenes.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace bench {

using robot::truth::Scene;
using robot::truth::SceneBall;
using robot::truth::SceneRobot;

namespace {

double distance_to_robots(const Scene& scene, double x, double y) {
  double nearest = 1e9;
  for (const SceneRobot& robot : scene.robots) nearest = std::min(nearest, std::hypot(robot.x - x, robot.y - y));
  return nearest;
}

}  // namespace

double TruthScenes::uniform(double least, double most) {
  return least + (most - least) * static_cast<double>(random_()) / 4294967296.;
}

double TruthScenes::normal() {
  double sum = -6;
  for (int i = 0; i < 12; ++i) sum += uniform(0, 1);
  return sum;
}

bool TruthScenes::in_view(double x, double y, double height) const {
  const Eigen::Vector2d pixel = pose_.pixel({x, y, height});
  return pixel.x() > 25 && pixel.x() < pose_.intrinsics.width - 25 && pixel.y() > 15 &&
         pixel.y() < pose_.intrinsics.height - 15;
}

SceneRobot TruthScenes::robot() {
  for (;;) {
    const SceneRobot robot{.x = uniform(-2.7, 2.7),
                           .y = uniform(-1.9, 1.9),
                           .heading = uniform(0, 2 * std::numbers::pi),
                           .fallen = uniform(0, 1) < 0.05,
                           .stride = uniform(-0.05, 0.05),
                           .arms = uniform(0, 1.2)};
    if (in_view(robot.x, robot.y, 0) && in_view(robot.x, robot.y, 0.6)) return robot;
  }
}

SceneBall TruthScenes::ball(const Scene& scene) {
  constexpr double kClear = 0.35;  // [m] from robots
  for (;;) {
    const SceneBall ball{uniform(-2.7, 2.7), uniform(-1.9, 1.9), ball_radius_, ball_radius_, colour_};
    if (in_view(ball.x, ball.y, ball.z) && distance_to_robots(scene, ball.x, ball.y) > kClear) return ball;
  }
}

Scene TruthScenes::next() {
  constexpr std::size_t kRobots = 5;
  constexpr double kApart = 0.36, kLyingApart = 0.5;  // [m]
  Scene scene;
  while (scene.robots.size() < kRobots) {
    const SceneRobot next = robot();
    if (distance_to_robots(scene, next.x, next.y) > (next.fallen ? kLyingApart : kApart)) scene.robots.push_back(next);
  }
  scene.ball = ball(scene);
  scene.people = {{-1.6, uniform(2.2, 2.5), uniform(0, 2 * std::numbers::pi), uniform(-0.3, 0.3)}};
  return scene;
}

}  // namespace bench
