// How good are velocities, identities and covariances of the fused truth, and what does an image cost? Prints a line of JSON
// for each part. The budget of an image is 0.1 ms with 10 robots on the lab's machine.
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <map>
#include <string>
#include <utility>

#include "robot/core/clock.h"
#include "robot/core/text.h"
#include "robot/truth/tracks/smoother.h"
#include "robot/truth/tracks/tracker.h"
#include "tests/support/truth_game.h"
#include "tests/support/truth_walk.h"

namespace {

using namespace robot::truth;
using robot::formatted;

constexpr std::size_t kTenMinutes = 18000;                                           // images
constexpr std::uint64_t kBegin = 1'700'000'000'000'000'000, kInterval = 33'333'333;  // [ns]
constexpr std::size_t kRobots = 8;

/// A game with the images of one sensor, one each step.
struct Recorded {
  std::vector<SensorImage> images;
  std::vector<std::vector<test::Mover>> robots;
  std::vector<test::Mover> balls;
  std::vector<bool> kicked;    // a kick or rebound came since the image before
  std::vector<OwnPose> poses;  // kRobots for each image
};

Recorded recorded(std::uint32_t seed, std::size_t steps, test::Watcher watcher) {
  Recorded all;
  test::TruthGame game(seed);
  test::Random random(seed + 1000);
  test::Localisation localisation(seed + 2000);
  for (std::size_t i = 0; i < steps; ++i) {
    game.step();
    const std::uint64_t time = kBegin + i * kInterval;
    all.images.push_back({0, watcher.look(game, time, random)});
    all.robots.push_back(game.robots());
    all.balls.push_back(game.ball());
    all.kicked.push_back(game.since_kick() == 0);
    for (const OwnPose& pose : localisation.poses(game, time)) all.poses.push_back(pose);
  }
  return all;
}

std::vector<FusedTruth> tracked(const Recorded& game, bool with_poses) {
  std::vector<FusedTruth> truths;
  Tracker tracker({Sensor{}});
  for (std::size_t i = 0; i < game.images.size(); ++i) {
    for (std::size_t robot = 0; with_poses && robot < kRobots; ++robot)
      (void)tracker.identify(game.poses[kRobots * i + robot]);
    (void)tracker.add(game.images[i]);
    truths.push_back(tracker.truth());
  }
  return truths;
}

class Rms {
 public:
  void add(const Eigen::Vector2d& error) {
    squares_ += error.squaredNorm();
    ++count_;
  }
  double value() const { return std::sqrt(squares_ / static_cast<double>(count_)); }

 private:
  double squares_ = 0;
  std::size_t count_ = 0;
};

double velocity_error(const Recorded& game, const std::vector<FusedTruth>& truths) {
  Rms rms;
  for (std::size_t i = 0; i + 1 < truths.size(); ++i) {
    const bool contact = game.kicked[i] || game.kicked[i + 1];
    if (truths[i].ball && !contact && game.balls[i].velocity.norm() > 0.05)
      rms.add(truths[i].ball->place.velocity - game.balls[i].velocity);
  }
  return rms.value();
}

/// Returns the share of kicks that the truth follows 0, 1, 2 and 3 images after the first one behind the contact.
std::array<double, 4> followed_share(const Recorded& game, const std::vector<FusedTruth>& truths) {
  std::array<double, 4> share{};
  double kicks = 0;
  for (std::size_t i = 0; i + share.size() < truths.size(); ++i) {
    if (!game.kicked[i] || game.balls[i].velocity.norm() < 0.7) continue;
    ++kicks;
    for (std::size_t later = 0; later < share.size(); ++later) {
      const std::optional<FusedBall>& ball = truths[i + later].ball;
      const Eigen::Vector2d velocity = game.balls[i + later].velocity;
      share[later] += ball && (ball->place.velocity - velocity).norm() < 0.3 * velocity.norm();
    }
  }
  for (double& part : share) part /= kicks;
  return share;
}

const FusedRobot* robot_at(const FusedTruth& truth, const Eigen::Vector2d& place) {
  const FusedRobot* found = nullptr;
  double least = 0.15;  // [m] half the distance of two robots
  for (const FusedRobot& robot : truth.robots)
    if (const double away = (robot.place.position - place).norm(); away < least) {
      least = away;
      found = &robot;
    }
  return found;
}

/// The numbers that one robot has had.
struct Switches {
  int tracks = 0, players = 0;
  double named = 0, wrong = 0, seen = 0;  // counts
};

Switches switches_of(const Recorded& game, const std::vector<FusedTruth>& truths) {
  Switches all;
  std::map<std::size_t, std::uint32_t> tracks, players;
  const auto changes = [](auto& numbers, std::size_t robot, std::uint32_t number) {
    const auto [known, is_new] = numbers.try_emplace(robot, number);
    return !is_new && std::exchange(known->second, number) != number;
  };
  for (std::size_t i = 0; i < truths.size(); ++i)
    for (std::size_t robot = 0; robot < kRobots; ++robot) {
      const FusedRobot* found = robot_at(truths[i], game.robots[i][robot].position);
      if (!found) continue;
      ++all.seen;
      all.tracks += changes(tracks, robot, found->place.track);
      if (!found->player) continue;
      ++all.named;
      all.wrong += found->team != game.poses[robot].team || found->player != game.poses[robot].player;
      all.players += changes(players, robot, 10 * *found->team + *found->player);
    }
  return all;
}

struct Honesty {
  double online = 0, smoothed = 0;
};

/// Returns mean normalised squared errors of walks, in the middle of each.
Honesty honesty_of(const std::vector<double>& deviations, int walks, test::Random& random) {
  Honesty mean;
  for (int i = 0; i < walks; ++i) {
    const test::Walk walk = test::walk_of(deviations, 60, random);
    mean.online += test::normalised_error(walk.online[30], walk.truth[30]) / walks;
    mean.smoothed += test::normalised_error(test::smoothed_walk(walk)[30], walk.truth[30]) / walks;
  }
  return mean;
}

/// Returns the measured variance of the places of walks [m²].
double variance_of(const std::vector<double>& deviations, int walks, test::Random& random) {
  Rms rms;
  for (int i = 0; i < walks; ++i) {
    const test::Walk walk = test::walk_of(deviations, 30, random);
    rms.add((walk.online.back().mean - walk.truth.back()).head<2>());
  }
  return rms.value() * rms.value() / 2;
}

std::pair<double, double> robot_errors_of(const Recorded& game, const std::vector<FusedTruth>& truths) {
  Rms place, velocity;
  for (std::size_t i = 0; i < truths.size(); ++i)
    for (const test::Mover& robot : game.robots[i])
      if (const FusedRobot* found = robot_at(truths[i], robot.position)) {
        place.add(found->place.position - robot.position);
        velocity.add(found->place.velocity - robot.velocity);
      }
  return {place.value(), velocity.value()};
}

/// Returns the velocity of a ball that rolls after kicks and rebounds, online and smoothed [m/s rms], in ten minutes of a game.
/// The noise is 1 cm; 30 images come a second, 5 % of them without the ball. Images around a contact do not count.
/// `followed_share` are the kicks that are followed within 30 % of their velocity, by the count of images since then.
std::string kicked_ball() {
  test::Watcher watcher;
  watcher.misses = 0.05;
  const Recorded game = recorded(1, kTenMinutes, watcher);
  const std::vector<FusedTruth> online = tracked(game, false);
  const std::array<double, 4> followed = followed_share(game, online);
  return formatted(
      R"({"part":"kicked ball","online_rms":%.4f,"smoothed_rms":%.4f,"followed_share":[%.2f,%.2f,%.2f,%.2f]})",
      velocity_error(game, online), velocity_error(game, *smooth({Sensor{}}, game.images)), followed[0], followed[1],
      followed[2], followed[3]);
}

/// Returns identity switches in ten minutes of 4v4, the most of three games: of tracks, and of players with own poses.
std::string identity_switches() {
  int tracks = 0, players = 0, smoothed_players = 0;
  double named = 1, wrong = 0;
  for (const std::uint32_t seed : {1u, 2u, 3u}) {
    const Recorded game = recorded(seed, kTenMinutes, {});
    const Switches with_poses = switches_of(game, tracked(game, true));
    tracks = std::max(tracks, switches_of(game, tracked(game, false)).tracks);
    players = std::max(players, with_poses.players);
    smoothed_players =
        std::max(smoothed_players, switches_of(game, *smooth({Sensor{}}, game.images, game.poses)).players);
    named = std::min(named, with_poses.named / with_poses.seen);
    wrong = std::max(wrong, with_poses.wrong / with_poses.named);
  }
  return formatted(
      R"({"part":"identity switches","of_tracks":%d,"of_players":%d,"smoothed_of_players":%d,"named_share":%.3f,"wrong_share":%.5f})",
      tracks, players, smoothed_players, named, wrong);
}

/// Returns mean normalised squared errors of place and velocity of robots that walk as the filter expects, and the 95 % band
/// around 4. Then the variance of two sensors relative to that of one, and errors of robots in a game.
std::string consistency() {
  constexpr int walks = 2000;
  test::Random random(5);
  const Honesty one = honesty_of({0.03}, walks, random), two = honesty_of({0.02, 0.04}, walks, random);
  const double ratio = variance_of({0.05, 0.05}, walks, random) / variance_of({0.05}, walks, random);
  const Recorded game = recorded(5, kTenMinutes / 2, {});
  const auto [place, velocity] = robot_errors_of(game, tracked(game, false));
  const auto [smoothed_place, smoothed_velocity] = robot_errors_of(game, *smooth({Sensor{}}, game.images));
  return formatted(
      R"({"part":"consistency","band":%.3f,"online":[%.3f,%.3f],"smoothed":[%.3f,%.3f],"two_sensors":%.3f,)"
      R"("robots_rms":%.4f,"robots_smoothed_rms":%.4f,"speed_rms":%.4f,"speed_smoothed_rms":%.4f})",
      1.96 * std::sqrt(8. / walks), one.online, two.online, one.smoothed, two.smoothed, ratio, place, smoothed_place,
      velocity, smoothed_velocity);
}

/// Returns the processor time of an image of one of two sensors with ten robots [ms].
std::string cost_of_an_image() {
  test::Watcher watcher;
  watcher.occlusions = false;
  Recorded game = recorded(7, 3000, watcher);
  Tracker tracker({Sensor{}, Sensor{}});
  std::size_t robots = 0, images = 0;
  const std::uint64_t begin_ns = robot::thread_cpu_ns();
  for (SensorImage& image : game.images) {
    for (const double y : {-2.8, 2.8}) {
      image.detections.robots.push_back(image.detections.robots.front());
      image.detections.robots.back().place.position = {0.1, y};
    }
    for (const std::size_t sensor : {0u, 1u}) {
      image.sensor = sensor;
      (void)tracker.add(image);
      robots += tracker.truth().robots.size();
      ++images;
    }
  }
  const double time = static_cast<double>(robot::thread_cpu_ns() - begin_ns) / 1e6;  // [ms]
  return formatted(R"({"part":"cost","ms_per_image":%.4f,"robots":%.2f})", time / static_cast<double>(images),
                   static_cast<double>(robots) / static_cast<double>(images));
}

}  // namespace

int main() {
  for (const auto& part : {kicked_ball, identity_switches, consistency, cost_of_an_image}) {
    std::puts(part().c_str());
    std::fflush(stdout);
  }
}
