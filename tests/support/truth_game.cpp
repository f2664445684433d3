#include "tests/support/truth_game.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace test {
namespace {

constexpr std::size_t kPoint = 100;
constexpr double kFastest = 0.4;                   // [m/s]
constexpr double kHalfLength = 3, kHalfWidth = 2;  // [m]
constexpr double kLeastApart = 0.3;                // [m]
constexpr double kFriction = 0.3;                  // [m/s²] not exactly the tracker's

Eigen::Vector2d within_field(const Eigen::Vector2d& point) {
  return {std::clamp(point.x(), -kHalfLength, kHalfLength), std::clamp(point.y(), -kHalfWidth, kHalfWidth)};
}

/// Reports whether a robot hides another one, seen from a mast of 2.1 m: less than 0.25 m of the other one protrude.
bool hides(const Eigen::Vector2d& near, const Eigen::Vector2d& far) {
  constexpr double mast = 2.1, robot = 0.57, protruding = 0.25, half_width = 0.12;  // [m]
  const double beyond = far.dot(near.normalized()) - near.norm();
  const double beside = std::abs(far.x() * near.y() - far.y() * near.x()) / near.norm();
  return beyond > 0.1 && beside < half_width && beyond * (mast - robot) < protruding * near.norm();
}

}  // namespace

double Random::normal() {
  const double radius = std::sqrt(-2 * std::log(uniform(0, 1)));
  return radius * std::cos(uniform(0, 2 * std::numbers::pi));
}

TruthGame::TruthGame(std::uint32_t seed) : random_(seed), robots_(8), plans_(8) {
  for (std::size_t i = 0; i < robots_.size(); ++i) {
    robots_[i].position = {-2.4 + 0.7 * static_cast<double>(i), i % 2 == 0 ? -1. : 1.};
    choose_target(i);
  }
}

void TruthGame::choose_target(std::size_t robot) {
  Plan& plan = plans_[robot];
  plan.chased = random_.chance(0.5) ? kPoint : (robot + 1 + static_cast<std::size_t>(random_.uniform(0, 7))) % 8;
  plan.point = {random_.uniform(-kHalfLength, kHalfLength), random_.uniform(-kHalfWidth, kHalfWidth)};
  plan.until = time_ + random_.uniform(2, 6);
  plan.speed = random_.uniform(0.15, 0.4);
}

/// Returns the robot of a team that is nearest to the ball. Robots 0 to 3 are one team.
std::size_t TruthGame::striker(std::size_t team) const {
  std::size_t nearest = 4 * team;
  for (std::size_t i = nearest; i < 4 * team + 4; ++i)
    if ((robots_[i].position - ball_.position).norm() < (robots_[nearest].position - ball_.position).norm())
      nearest = i;
  return nearest;
}

/// Returns the place to which a robot walks: a striker to the ball, the others to a point or close to another robot.
Eigen::Vector2d TruthGame::target_of(std::size_t robot) const {
  if (robot == striker(robot / 4)) return ball_.position;
  const Plan& plan = plans_[robot];
  if (plan.chased == kPoint) return plan.point;
  const Eigen::Vector2d way = robots_[plan.chased].position - robots_[robot].position;
  return robots_[robot].position + way * std::max(0., 1 - 0.6 / way.norm());
}

void TruthGame::move_robots() {
  for (std::size_t i = 0; i < robots_.size(); ++i) {
    if (time_ >= plans_[i].until) choose_target(i);
    const Eigen::Vector2d way = target_of(i) - robots_[i].position;
    Eigen::Vector2d wanted = way.norm() > 0.1 ? (plans_[i].speed * way.normalized()).eval() : Eigen::Vector2d(0, 0);

    // it walks around others that are near
    for (std::size_t j = 0; j < robots_.size(); ++j) {
      const Eigen::Vector2d from = robots_[i].position - robots_[j].position;
      if (j != i && from.norm() < 0.6) wanted += 0.5 * (0.6 - from.norm()) / 0.3 * from.normalized();
    }
    if (wanted.norm() > kFastest) wanted *= kFastest / wanted.norm();

    // a walk needs half a second to change its speed
    robots_[i].velocity += kStep / 0.4 * (wanted - robots_[i].velocity);
    robots_[i].position += kStep * robots_[i].velocity;
  }
}

void TruthGame::keep_apart() {
  for (std::size_t i = 0; i < robots_.size(); ++i)
    for (std::size_t j = 0; j < i; ++j) {
      const Eigen::Vector2d way = robots_[i].position - robots_[j].position;
      const double missing = kLeastApart - way.norm();
      if (missing <= 0) continue;
      // they slide along each other
      const Eigen::Vector2d direction = way.normalized();
      const double closing = std::min(0., direction.dot(robots_[i].velocity - robots_[j].velocity));
      robots_[i].velocity -= closing / 2 * direction;
      robots_[j].velocity += closing / 2 * direction;
      robots_[i].position += missing / 2 * direction;
      robots_[j].position -= missing / 2 * direction;
    }
}

void TruthGame::move_ball() {
  since_kick_ += kStep;
  const double speed = ball_.velocity.norm();
  const double slowed = std::min(speed, kFriction * kStep);
  ball_.position += kStep * (speed > 0 ? 1 - slowed / (2 * speed) : 0.) * ball_.velocity;
  if (speed > 0) ball_.velocity *= 1 - slowed / speed;

  const bool had = std::any_of(robots_.begin(), robots_.end(),
                               [&](const Mover& robot) { return (robot.position - ball_.position).norm() < 0.3; });
  const bool kicked = had && speed < 0.3 && since_kick_ > 1 && random_.chance(0.05);
  const Eigen::Vector2d inside = within_field(ball_.position);
  const bool rebounds = inside != ball_.position;
  if (!kicked && !rebounds) return;

  // the kick comes at a random moment of the step
  const Eigen::Vector2d before = ball_.velocity;
  const double direction = random_.uniform(-std::numbers::pi, std::numbers::pi);
  if (kicked) ball_.velocity = random_.uniform(0.5, 2.5) * Eigen::Vector2d(std::cos(direction), std::sin(direction));
  if (rebounds) {
    if (inside.x() != ball_.position.x()) ball_.velocity.x() = -0.6 * ball_.velocity.x();
    if (inside.y() != ball_.position.y()) ball_.velocity.y() = -0.6 * ball_.velocity.y();
    ball_.position = inside;
  }
  ball_.position += random_.uniform(0, 1) * kStep * (ball_.velocity - before);
  since_kick_ = 0;
}

void TruthGame::step() {
  time_ += kStep;
  move_robots();
  keep_apart();
  move_ball();
}

robot::truth::Detections Watcher::look(const TruthGame& game, std::uint64_t capture_ns, Random& random) {
  robot::truth::Detections seen{.capture_ns = capture_ns, .detected_ns = capture_ns + 2'000'000};
  const auto place_of = [&](const Eigen::Vector2d& position, double noise) {
    return robot::truth::Place{position + offset + noise * random.normal2(),
                               noise * noise * Eigen::Matrix2d::Identity()};
  };
  for (std::size_t i = 0; i < game.robots().size(); ++i) {
    const bool behind = std::any_of(game.robots().begin(), game.robots().end(), [&](const Mover& other) {
      return hides(other.position - place, game.robots()[i].position - place);
    });
    hidden_for[i] = occlusions && behind ? hidden_for[i] + TruthGame::kStep : 0;
    const bool hidden = hidden_for[i] > 0 && hidden_for[i] < 2;
    const robot::truth::Place place_seen = place_of(game.robots()[i].position, robot_noise);
    if (!random.chance(misses) && !hidden) seen.robots.push_back({.place = place_seen, .height = 0.57});
  }
  if (random.chance(false_robots))
    seen.robots.push_back(
        {.place = place_of({random.uniform(-3, 3), random.uniform(-2, 2)}, robot_noise), .height = 0.5});
  const robot::truth::Place ball = place_of(game.ball().position, ball_noise);
  if (!random.chance(misses)) seen.ball = robot::truth::SeenBall{ball};
  return seen;
}

std::vector<robot::truth::OwnPose> Localisation::poses(const TruthGame& game, std::uint64_t capture_ns) {
  constexpr double memory = 3, deviation = 0.15;  // [s], [m]
  const double kept = std::exp(-TruthGame::kStep / memory);
  std::vector<robot::truth::OwnPose> poses;
  for (std::size_t i = 0; i < errors_.size(); ++i) {
    errors_[i] = kept * errors_[i] + std::sqrt(1 - kept * kept) * deviation * random_.normal2();
    flipped_for_[i] = std::max(0., flipped_for_[i] - TruthGame::kStep);
    if (random_.chance(TruthGame::kStep / 60)) flipped_for_[i] = random_.uniform(1, 5);
    const Eigen::Vector2d believed = game.robots()[i].position + errors_[i];
    poses.push_back({.capture_ns = capture_ns,
                     .team = i < 4 ? 1u : 2u,
                     .player = static_cast<std::uint32_t>(i % 4 + 1),
                     .position = flipped_for_[i] > 0 ? (-believed).eval() : believed,
                     .deviation = 0.2});
  }
  return poses;
}

}  // namespace test
