// How exact is the truth of an ordinary camera with printed tags? The bars: 2 cm, 2 degrees, and no wrong identity in 10,000
// frames of 1280x720 px at 2.5 to 3 m height, tags with edges of 12 to 16 cm. It prints one JSON line per camera and one
// for all.
//
//   bench_truth_tags [FRAMES] [SEED]
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <nlohmann/json.hpp>
#include <numbers>
#include <string>
#include <vector>

#include "robot/core/clock.h"
#include "robot/truth/tags/tag_watcher.h"
#include "sim/statistics/sample.h"
#include "tests/support/jpeg_pictures.h"
#include "tests/support/rendered_pictures.h"
#include "tests/support/tagged_scenes.h"

namespace {

using robot::truth::Detections;
using robot::truth::Intrinsics;
using robot::truth::SeenRobot;
using robot::truth::tags::Camera;
using robot::truth::tags::TagWatcher;
using tests::TaggedScene;
using tests::TrueRobot;
using namespace sim::statistics;

/// All errors of some frames.
struct Account {
  std::vector<double> position_cm, heading_deg, lying_cm, touched_cm, ball_cm, milliseconds;
  double normalised = 0;  // sum of squared errors of places, each divided by its covariance
  int frames = 0, robots = 0, found = 0, lying_robots = 0, lying_found = 0, balls = 0, balls_found = 0,
      wrong_identities = 0, wrong_postures = 0, false_balls = 0;
};

double degrees(double radians) {
  return std::abs(std::remainder(radians, 2 * std::numbers::pi)) * 180 / std::numbers::pi;
}

const TrueRobot* same_robot(const TaggedScene& scene, const SeenRobot& seen) {
  for (const TrueRobot& robot : scene.robots)
    if (robot.team == *seen.team && robot.player == *seen.player) return &robot;
  return nullptr;
}

void count_robot(Account& account, const TaggedScene& scene, const SeenRobot& seen) {
  const TrueRobot* robot = same_robot(scene, seen);
  const Eigen::Vector2d error = robot ? Eigen::Vector2d(seen.place.position - robot->place) : Eigen::Vector2d(9, 9);
  if (error.norm() > 0.3) {
    ++account.wrong_identities;
  } else if (robot->lies != !seen.heading) {
    ++account.wrong_postures;
  } else if (robot->lies) {
    account.lying_cm.push_back(100 * error.norm());
  } else if (robot->touched) {
    account.touched_cm.push_back(100 * error.norm());
  } else {
    account.position_cm.push_back(100 * error.norm());
    account.heading_deg.push_back(degrees(*seen.heading - robot->heading));
    account.normalised += error.dot(seen.place.covariance.inverse() * error);
  }
}

/// Reports whether the picture shows the whole tag with its margin. Other robots may hide it.
bool is_in_view(const Camera& camera, const TrueRobot& robot) {
  const Intrinsics& picture = camera.projection.intrinsics;
  for (const double x : {-0.625, 0.625})
    for (const double y : {-0.625, 0.625}) {
      const auto pixel = camera.pixel(robot.field_from_tag * Eigen::Vector3d(x * robot.edge, y * robot.edge, 0));
      if (!pixel || pixel->minCoeff() < 0 || pixel->x() > picture.width || pixel->y() > picture.height) return false;
    }
  return true;
}

bool is_found(const TrueRobot& robot, const Detections& seen) {
  const auto same = [&](const SeenRobot& other) { return other.team == robot.team && other.player == robot.player; };
  return std::any_of(seen.robots.begin(), seen.robots.end(), same);
}

void count_frame(Account& account, const Camera& camera, const TaggedScene& scene, const Detections& seen) {
  ++account.frames;
  for (const TrueRobot& robot : scene.robots) {
    if (!is_in_view(camera, robot) || robot.touched) continue;
    ++(robot.lies ? account.lying_robots : account.robots);
    if (is_found(robot, seen)) ++(robot.lies ? account.lying_found : account.found);
  }
  for (const SeenRobot& robot : seen.robots) count_robot(account, scene, robot);
  const bool shown = tests::shows_ball(scene, camera);
  if (shown) ++account.balls;
  if (!seen.ball) return;
  if (shown) ++account.balls_found;
  const double error = (seen.ball->place.position - scene.ball).norm();
  if (error > 0.3)
    ++account.false_balls;
  else
    account.ball_cm.push_back(100 * error);
}

nlohmann::json spread(const std::vector<double>& values) {
  return {{"mean", mean_of(values)},
          {"median", median(values)},
          {"p95", quantile(values, 0.95)},
          {"max", quantile(values, 1)}};
}

void print(const std::string& name, const Account& account) {
  const auto exact = static_cast<double>(account.position_cm.size());
  const nlohmann::json line{
      {"name", name},
      {"frames", account.frames},
      {"position_cm", spread(account.position_cm)},
      {"heading_deg", spread(account.heading_deg)},
      {"recall", ratio(account.found, account.robots)},
      {"wrong_identities", account.wrong_identities},
      {"wrong_postures", account.wrong_postures},
      {"normalised_error", ratio(account.normalised / 2, exact)},
      {"lying", {{"recall", ratio(account.lying_found, account.lying_robots)}, {"cm", spread(account.lying_cm)}}},
      {"touched_cm", spread(account.touched_cm)},
      {"ball",
       {{"recall", ratio(account.balls_found, account.balls)},
        {"cm", spread(account.ball_cm)},
        {"false", account.false_balls}}},
      {"look_ms", spread(account.milliseconds)}};
  std::puts(line.dump().c_str());
  std::fflush(stdout);
}

void add(std::vector<double>& to, const std::vector<double>& from) { to.insert(to.end(), from.begin(), from.end()); }

void add(Account& all, const Account& account) {
  add(all.position_cm, account.position_cm);
  add(all.heading_deg, account.heading_deg);
  add(all.lying_cm, account.lying_cm);
  add(all.touched_cm, account.touched_cm);
  add(all.ball_cm, account.ball_cm);
  add(all.milliseconds, account.milliseconds);
  all.normalised += account.normalised;
  all.frames += account.frames;
  all.robots += account.robots;
  all.found += account.found;
  all.lying_found += account.lying_found;
  all.lying_robots += account.lying_robots;
  all.balls += account.balls;
  all.balls_found += account.balls_found;
  all.wrong_identities += account.wrong_identities;
  all.wrong_postures += account.wrong_postures;
  all.false_balls += account.false_balls;
}

/// Watches `frames` scenes with one camera. Exits if this build sees no tags.
Account watch(const Camera& camera, int frames, std::mt19937& random) {
  const tests::Renderer renderer(camera);
  auto watcher = TagWatcher::create(camera, tests::plan_of_scenes());
  if (!watcher) {
    std::fprintf(stderr, "%s\n", watcher.error().c_str());
    std::exit(1);
  }
  Account account;
  for (int i = 0; i < frames; ++i) {
    const TaggedScene scene = tests::random_scene(random);
    const auto rendered = renderer.render(scene.things, scene.conditions);
    const auto picture = i % 2 == 0 ? rendered : tests::as_jpeg(rendered, 85);  // as from a webcam
    const std::uint64_t start_ns = robot::thread_cpu_ns();
    const auto seen = watcher->look(picture);
    account.milliseconds.push_back(static_cast<double>(robot::thread_cpu_ns() - start_ns) / 1e6);
    count_frame(account, camera, scene, *seen);
  }
  return account;
}

}  // namespace

int main(int count, char** words) {
  constexpr int kCameras = 5;
  const int frames = count > 1 ? std::atoi(words[1]) : 10'000;
  std::mt19937 random(count > 2 ? static_cast<std::uint32_t>(std::atoi(words[2])) : 1);
  Account all;
  for (int i = 0; i < kCameras; ++i) {
    const auto camera = tests::random_camera(random);
    const Account account = watch(camera, frames / kCameras, random);
    print("camera " + std::to_string(i + 1), account);
    add(all, account);
  }
  print("all", all);
}
