#include "tests/bench/truth_tracks.h"

#include <Eigen/LU>
#include <chrono>
#include <cmath>
#include <map>
#include <set>

#include "robot/core/text.h"
#include "robot/truth/tracks/motion.h"
#include "robot/truth/tracks/smoother.h"
#include "robot/truth/tracks/tracker.h"
#include "tests/support/truth_game.h"

using namespace robot::truth;
using robot::formatted;
using test::Localisation;
using test::Random;
using test::TruthGame;
using test::Watcher;

namespace {

constexpr std::uint64_t kBegin = 1'700'000'000'000'000'000, kImage = 33'333'333;  // [ns]

std::uint64_t time_of(std::size_t image) { return kBegin + image * kImage; }

struct Rms {
  double squares = 0;
  std::size_t count = 0;
  void add(const Eigen::Vector2d& error) { squares += error.squaredNorm(), ++count; }
  double value() const { return std::sqrt(squares / static_cast<double>(count)); }
};

/// Mean of normalised squared errors of two numbers, relative to the expected 2; 1: honest.
struct Honesty {
  double sum = 0;
  std::size_t count = 0, within = 0;
  void add(const Eigen::Vector2d& error, const Eigen::Matrix2d& covariance) {
    const double squared = error.dot(covariance.inverse() * error);
    sum += squared / 2;
    ++count;
    within += squared <= 5.99;
  }
  double value() const { return sum / static_cast<double>(count); }
  double coverage() const { return static_cast<double>(within) / static_cast<double>(count); }
};

struct Recorded {
  std::vector<SensorImage> images;
  std::vector<std::vector<test::Mover>> robots;  // by image
  std::vector<test::Mover> balls;
  std::vector<double> since_kick;
  std::vector<OwnPose> poses;
};

Recorded recorded(std::uint32_t seed, std::size_t steps, std::vector<Watcher> watchers) {
  Recorded all;
  TruthGame game(seed);
  Random random(seed + 1000);
  Localisation localisation(seed + 2000);
  for (std::size_t i = 0; i < steps; ++i) {
    game.step();
    for (std::size_t sensor = 0; sensor < watchers.size(); ++sensor) {
      all.images.push_back({sensor, watchers[sensor].look(game, time_of(i), random)});
      all.robots.push_back(game.robots());
      all.balls.push_back(game.ball());
      all.since_kick.push_back(game.since_kick());
    }
    for (const OwnPose& pose : localisation.poses(game, time_of(i))) all.poses.push_back(pose);
  }
  return all;
}

const FusedRobot* nearest(const FusedTruth& truth, const Eigen::Vector2d& place) {
  const FusedRobot* found = nullptr;
  double least = 0.15;
  for (const FusedRobot& robot : truth.robots)
    if (const double away = (robot.place.position - place).norm(); away < least) least = away, found = &robot;
  return found;
}

struct Identities {
  std::map<std::size_t, std::uint32_t> tracks, players;
  int track_switches = 0, player_switches = 0;
  std::size_t named = 0, wrong = 0, seen = 0;

  void add(const FusedTruth& truth, const std::vector<test::Mover>& robots) {
    for (std::size_t i = 0; i < robots.size(); ++i) {
      const FusedRobot* robot = nearest(truth, robots[i].position);
      if (!robot) continue;
      ++seen;
      auto [track, is_new] = tracks.try_emplace(i, robot->place.track);
      track_switches += !is_new && track->second != robot->place.track;
      track->second = robot->place.track;
      if (!robot->player) continue;
      const std::uint32_t number = 10 * *robot->team + *robot->player;
      const std::uint32_t right = i < 4 ? static_cast<std::uint32_t>(11 + i) : static_cast<std::uint32_t>(17 + i);
      ++named;
      wrong += number != right;
      auto [player, first] = players.try_emplace(i, number);
      player_switches += !first && player->second != number;
      player->second = number;
    }
  }
};

Identities identities(const Recorded& game, bool with_poses, bool smoothing) {
  Identities result;
  if (smoothing) {
    const auto truths = smooth({Sensor{}}, game.images, with_poses ? game.poses : std::vector<OwnPose>{});
    for (std::size_t i = 0; i < truths->size(); ++i) result.add((*truths)[i], game.robots[i]);
    return result;
  }
  Tracker tracker({Sensor{}});
  for (std::size_t i = 0; i < game.images.size(); ++i) {
    if (with_poses)
      for (std::size_t player = 0; player < 8; ++player) (void)tracker.identify(game.poses[8 * i + player]);
    (void)tracker.add(game.images[i]);
    result.add(tracker.truth(), game.robots[i]);
  }
  return result;
}

}  // namespace

std::string kicked_ball() {
  Watcher watcher;
  watcher.misses = 0.05;
  const Recorded game = recorded(1, 18000, {watcher});
  Rms online, smoothed, all, position;
  Honesty velocity, place, online_velocity;
  int lag[4] = {}, kicks = 0;
  const auto truths = smooth({Sensor{}}, game.images);
  Tracker tracker({Sensor{}});
  for (std::size_t i = 0; i + 1 < game.images.size(); ++i) {
    (void)tracker.add(game.images[i]);
    const FusedTruth now = tracker.truth();
    // a velocity is undefined within the contact
    const bool contact = game.since_kick[i] < 0.02 || game.since_kick[i + 1] < 0.02;
    if (game.since_kick[i] == 0 && game.balls[i].velocity.norm() > 0.7) {
      ++kicks;
      for (std::size_t n = 0; n < 4 && i + n < game.images.size(); ++n) {
        // judged after the loop's own tracker has seen them: a copy looks ahead
        Tracker ahead({Sensor{}});
        for (std::size_t k = i < 60 ? 0 : i - 60; k <= i + n; ++k) (void)ahead.add(game.images[k]);
        const FusedTruth truth = ahead.truth();
        lag[n] += truth.ball && (truth.ball->place.velocity - game.balls[i + n].velocity).norm() <
                                    0.3 * game.balls[i + n].velocity.norm();
      }
    }
    if (now.ball && !contact && game.balls[i].velocity.norm() > 0.05) {
      online.add(now.ball->place.velocity - game.balls[i].velocity);
      online_velocity.add(now.ball->place.velocity - game.balls[i].velocity, now.ball->place.velocity_covariance);
    }
    if (const auto& ball = (*truths)[i].ball) {
      all.add(ball->place.velocity - game.balls[i].velocity);
      if (contact) continue;
      if (game.balls[i].velocity.norm() > 0.05) {
        smoothed.add(ball->place.velocity - game.balls[i].velocity);
        velocity.add(ball->place.velocity - game.balls[i].velocity, ball->place.velocity_covariance);
      }
      position.add(ball->place.position - game.balls[i].position);
      place.add(ball->place.position - game.balls[i].position, ball->place.covariance);
    }
  }
  return formatted(
      R"({"part":"kicked ball","kicks":%d,"online_rms":%.4f,"smoothed_rms":%.4f,"with_contacts_rms":%.4f,"position_rms":%.4f,)"
      R"("followed_after":[%d,%d,%d,%d],"honesty_velocity":%.3f,"honesty_place":%.3f,"coverage_velocity":%.3f,"online_honesty":%.3f,"online_coverage":%.3f})",
      kicks, online.value(), smoothed.value(), all.value(), position.value(), lag[0], lag[1], lag[2], lag[3],
      velocity.value(), place.value(), velocity.coverage(), online_velocity.value(), online_velocity.coverage());
}

std::string identity_switches() {
  std::string lines;
  for (std::uint32_t seed = 1; seed <= 3; ++seed) {
    const Recorded game = recorded(seed, 18000, {Watcher{}});
    const Identities without = identities(game, false, false), with = identities(game, true, false),
                     after = identities(game, false, true), both = identities(game, true, true);
    lines += formatted(
        R"({"part":"identity","seed":%u,"track_switches":%d,"with_poses_track":%d,"with_poses_player":%d,"named":%.4f,"wrong":%.5f,)"
        R"("smoothed_track":%d,"smoothed_player":%d,"smoothed_named":%.4f,"smoothed_wrong":%.5f,"seen":%zu})"
        "\n",
        seed, without.track_switches, with.track_switches, with.player_switches,
        static_cast<double>(with.named) / static_cast<double>(with.seen),
        static_cast<double>(with.wrong) / static_cast<double>(with.named), after.track_switches, both.player_switches,
        static_cast<double>(both.named) / static_cast<double>(both.seen),
        static_cast<double>(both.wrong) / static_cast<double>(both.named), with.seen);
  }
  lines.pop_back();
  return lines;
}

std::string consistency() {
  Honesty online_place, online_velocity, place, velocity;
  Rms one_rms, two_rms, one_smooth, two_smooth, vel_online, vel_smooth;
  const Recorded game = recorded(5, 9000, {Watcher{}});
  const auto truths = smooth({Sensor{}}, game.images);
  Tracker tracker({Sensor{}});
  for (std::size_t i = 0; i < game.images.size(); ++i) {
    (void)tracker.add(game.images[i]);
    const FusedTruth now = tracker.truth();
    for (const test::Mover& robot : game.robots[i]) {
      if (const FusedRobot* found = nearest(now, robot.position)) {
        online_place.add(found->place.position - robot.position, found->place.covariance);
        online_velocity.add(found->place.velocity - robot.velocity, found->place.velocity_covariance);
        one_rms.add(found->place.position - robot.position);
        vel_online.add(found->place.velocity - robot.velocity);
      }
      if (const FusedRobot* found = nearest((*truths)[i], robot.position)) {
        place.add(found->place.position - robot.position, found->place.covariance);
        velocity.add(found->place.velocity - robot.velocity, found->place.velocity_covariance);
        one_smooth.add(found->place.position - robot.position);
        vel_smooth.add(found->place.velocity - robot.velocity);
      }
    }
  }
  return formatted(
      R"({"part":"consistency of a game","online_place":%.3f,"online_velocity":%.3f,"smoothed_place":%.3f,"smoothed_velocity":%.3f,)"
      R"("coverage":[%.3f,%.3f,%.3f,%.3f],"online_rms":%.4f,"smoothed_rms":%.4f,"velocity_online":%.4f,"velocity_smoothed":%.4f})",
      online_place.value(), online_velocity.value(), place.value(), velocity.value(), online_place.coverage(),
      online_velocity.coverage(), place.coverage(), velocity.coverage(), one_rms.value(), one_smooth.value(),
      vel_online.value(), vel_smooth.value());
}

std::string cost() {
  const Recorded game = recorded(7, 3000, {Watcher{}, Watcher{}});
  Tracker tracker({Sensor{}, Sensor{}});
  std::size_t robots = 0;
  const auto begin = std::chrono::steady_clock::now();
  for (const SensorImage& image : game.images) {
    SensorImage more = image;
    for (double y : {-2.8, 2.8})
      more.detections.robots.push_back({.place = {{0.1, y}, 4e-4 * Eigen::Matrix2d::Identity()}, .height = 0.5});
    (void)tracker.add(more);
    robots += tracker.truth().robots.size();
  }
  const std::chrono::duration<double, std::milli> time = std::chrono::steady_clock::now() - begin;
  const auto images = static_cast<double>(game.images.size());
  return formatted(R"({"part":"cost","ms_per_image":%.4f,"robots":%.2f})", time.count() / images,
                   static_cast<double>(robots) / images);
}
