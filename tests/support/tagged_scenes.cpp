#include "tests/support/tagged_scenes.h"

#include <algorithm>
#include <cmath>
#include <memory>
#include <numbers>
#include <utility>

#include "tests/support/camera_above.h"

namespace tests {
namespace {

using robot::truth::tags::Camera;
using robot::truth::tags::Mounting;
using robot::truth::tags::TaggedRobot;
using robot::truth::tags::TagPlan;

constexpr int kUnknownId = 400;
const Light kShell{0.6f, 0.6f, 0.62f}, kOrange{0.75f, 0.2f, 0.02f}, kArm{0.5f, 0.1f, 0.1f};

double uniform(std::mt19937& random, double from, double to) {
  return from + (to - from) * static_cast<double>(random()) / 4294967296.0;
}

/// Returns a number of deviation 1 that is nearly normal: the sum of twelve uniform ones.
double nearly_normal(std::mt19937& random) {
  double sum = -6;
  for (int i = 0; i < 12; ++i) sum += uniform(random, 0, 1);
  return sum;
}

/// Returns a place at least 0.4 m from the others.
Eigen::Vector2d free_place(std::mt19937& random, const std::vector<Eigen::Vector2d>& others) {
  while (true) {
    Eigen::Vector2d place{uniform(random, -2.2, 2.2), uniform(random, -1.6, 1.6)};
    const auto near = [&](const Eigen::Vector2d& other) { return (other - place).norm() < 0.4; };
    if (std::none_of(others.begin(), others.end(), near)) return place;
  }
}

Eigen::Isometry3d swaying_tag(std::mt19937& random, const TrueRobot& robot, const Mounting& mounting) {
  const double c = std::cos(robot.heading), s = std::sin(robot.heading);
  const Eigen::Vector3d centre{robot.place.x() + c * mounting.forward - s * mounting.left,
                               robot.place.y() + s * mounting.forward + c * mounting.left,
                               mounting.height + 0.005 * nearly_normal(random)};
  const Eigen::Vector3d sway{2 * kDegree * nearly_normal(random), 2 * kDegree * nearly_normal(random), 0};
  Eigen::Isometry3d pose = flat_tag(centre, robot.heading + mounting.turn);
  if (sway.norm() > 0) pose.linear() = Eigen::AngleAxisd(sway.norm(), sway.normalized()) * pose.linear();
  return pose;
}

/// Returns the tag of a robot that lies: upright on its edge, 10 cm above the carpet, towards the camera.
Eigen::Isometry3d lying_tag(const TrueRobot& robot) {
  Eigen::Isometry3d pose = Eigen::Isometry3d::Identity();
  pose.linear() = Eigen::AngleAxisd(robot.heading, Eigen::Vector3d::UnitZ()) *
                  Eigen::AngleAxisd(75 * kDegree, Eigen::Vector3d::UnitX()).toRotationMatrix();
  pose.translation() << robot.place, 0.1;
  return pose;
}

void add_robot(TaggedScene& scene, std::mt19937& random, int id, const TaggedRobot& planned,
               const Eigen::Vector2d& place) {
  const Mounting& mounting = planned.mounting;
  TrueRobot robot{.team = planned.team,
                  .player = planned.player,
                  .place = place,
                  .heading = uniform(random, -std::numbers::pi, std::numbers::pi),
                  .lies = random() % 30 == 0};
  if (robot.lies) robot.heading = uniform(random, -0.5, 0.5);
  const Eigen::Isometry3d pose = robot.lies ? lying_tag(robot) : swaying_tag(random, robot, mounting);
  scene.things.push_back(printed_tag(id, pose, mounting.edge));
  if (!robot.lies) scene.things.push_back(cylinder(place, 0.11, mounting.height - 0.03, kShell));
  robot.field_from_tag = pose;
  robot.edge = mounting.edge;
  robot.touched = random() % 10 == 0;
  if (robot.touched) {
    const Eigen::Vector3d beside{uniform(random, -0.1, 0.1), uniform(random, -0.1, 0.1), 0.08};
    scene.things.push_back(sphere(pose.translation() + beside, 0.03, kArm));
  }
  scene.robots.push_back(robot);
}

}  // namespace

TagPlan plan_of_scenes() {
  TagPlan plan;
  for (int i = 0; i < 10; ++i)
    plan.tags[i * 7] = {.team = i < 5 ? 5u : 18u,
                        .player = static_cast<std::uint32_t>(i % 5 + 1),
                        .mounting = {.edge = 0.12 + 0.01 * (i % 5),
                                     .height = i % 2 == 0 ? 0.58 : 0.45,
                                     .forward = 0.02 * (i % 3),
                                     .left = i % 2 == 0 ? 0 : 0.05,
                                     .turn = i % 4 * 90 * kDegree}};
  return plan;
}

Camera random_camera(std::mt19937& random) {
  const Eigen::Vector3d from{uniform(random, -0.3, 0.3), uniform(random, -1.6, -0.6), uniform(random, 2.5, 3)};
  Camera camera = camera_above(from, {0, 0}, {1280, 720}, uniform(random, 640, 720));
  camera.projection.lens.k1 = uniform(random, -0.15, -0.05);
  camera.projection.lens.k2 = 0.02;
  camera.projection.lens.p1 = uniform(random, -0.001, 0.001);
  camera.projection.lens.p2 = uniform(random, -0.001, 0.001);
  return camera;
}

TaggedScene random_scene(std::mt19937& random) {
  TaggedScene scene;
  scene.conditions = {.brightness = uniform(random, 0.35, 1.1),
                      .slope = uniform(random, -0.5, 0.5),
                      .blur = uniform(random, 0.5, 0.9),
                      .noise = uniform(random, 1, 4),
                      .seed = static_cast<std::uint32_t>(random())};
  const TagPlan plan = plan_of_scenes();
  std::vector<Eigen::Vector2d> places;
  for (const auto& [id, planned] : plan.tags) {
    if (random() % 10 < 4) continue;
    places.push_back(free_place(random, places));
    add_robot(scene, random, id, planned, places.back());
  }
  places.push_back(free_place(random, places));
  scene.things.push_back(
      printed_tag(kUnknownId, flat_tag({places.back().x(), places.back().y(), 0.5}, uniform(random, -3, 3)), 0.14));
  scene.ball = free_place(random, places);
  scene.things.push_back(sphere({scene.ball.x(), scene.ball.y(), kSceneBallRadius}, kSceneBallRadius, kOrange));
  return scene;
}

bool shows_ball(const TaggedScene& scene, const Camera& camera) {
  const Eigen::Vector3d ball{scene.ball.x(), scene.ball.y(), kSceneBallRadius};
  const auto pixel = camera.pixel(ball);
  const auto& picture = camera.projection.intrinsics;
  const double margin = 15;  // [px] more than its radius
  if (!pixel || pixel->minCoeff() < margin || pixel->x() > picture.width - margin ||
      pixel->y() > picture.height - margin)
    return false;
  const Eigen::Vector3d from = camera.field_from_camera.translation();
  const auto hides = [&](const std::unique_ptr<Thing>& thing) {
    const auto hit = thing->hit(from, ball - from);
    return hit && hit->distance > 0 && hit->distance < 1 - 2 * kSceneBallRadius / (ball - from).norm();
  };
  return std::none_of(scene.things.begin(), scene.things.end(), hides);
}

}  // namespace tests
