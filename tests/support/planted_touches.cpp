#include "tests/support/planted_touches.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>

namespace robot::tests {
namespace {

struct Vector2 {
  double x = 0, y = 0;

  Vector2 turned(double angle) const {
    const double c = std::cos(angle), s = std::sin(angle);
    return {c * x - s * y, s * x + c * y};
  }
};

double dot(Vector2 a, Vector2 b) { return a.x * b.x + a.y * b.y; }
Vector2 sum(Vector2 a, double factor, Vector2 b) { return {a.x + factor * b.x, a.y + factor * b.y}; }

/// Returns the way of a ball with a velocity at time 0, before and after it.
Vector2 way(Vector2 velocity, double deceleration, double time) {
  const double speed = std::hypot(velocity.x, velocity.y);
  if (speed == 0) return {};
  const double rolls = std::min(time, speed / deceleration);
  return sum({}, rolls - deceleration * rolls * rolls / 2 / speed, velocity);
}

class Recorder {
 public:
  Recorder(const PlantedTouches& planted, std::uint64_t seed) : planted_(planted), random_(seed) {
    record_.ball_deviation = std::max(0.001, planted.truth_error);
    record_.robots.push_back({.name = "14/2", .path = {}});
  }

  double uniform(double low, double high) {
    return low + (high - low) * std::uniform_real_distribution<double>()(random_);
  }
  double normal() { return std::normal_distribution<double>()(random_); }

  /// Adds the ball that meets something at `at` after 1.2 s, and the robot if there is one.
  void add(Vector2 at, Vector2 before, Vector2 after, bool has_robot, Vector2 robot, Vector2 own) {
    const double moment = 1.2 + uniform(0, 1 / 30.);
    for (int i = 0; i < 90; ++i) {
      const double time = i / 30. - moment;
      place(record_.ball, sum(at, 1, way(time < 0 ? before : after, planted_.deceleration, time)), begin_ + i / 30.);
      record_.sightings.push_back({.at = begin_ + i / 30., .seen = true});
      if (has_robot) place(record_.robots[0].path, sum(robot, std::min(time, 0.5), own), begin_ + i / 30.);
    }
    begin_ += 5;
  }

  lab::TruthRecord record() && { return std::move(record_); }

 private:
  void place(lab::Path& path, Vector2 where, double at) {
    const double x = where.x + planted_.truth_error * normal(), y = where.y + planted_.truth_error * normal();
    path.push_back({.at = at, .x = x, .y = planted_.mirrored * y});
  }

  const PlantedTouches& planted_;
  std::mt19937_64 random_;
  lab::TruthRecord record_;
  double begin_ = 0;
};

/// Returns the velocity after a rebound off a thing with the velocity `own`.
Vector2 rebounded(Vector2 before, Vector2 away, double restitution, Vector2 own) {
  return sum(before, -(1 + restitution) * (dot(before, away) - dot(own, away)), away);
}

void add_rebound(Recorder& recorder, Vector2 middle, double reach, double restitution, Vector2 away, bool has_robot) {
  const Vector2 before = sum({}, -recorder.uniform(0.6, 1.5), away.turned(recorder.uniform(-0.5, 0.5)));
  recorder.add(sum(middle, reach, away), before, rebounded(before, away, restitution, {}), has_robot, middle, {});
}

void add_push(Recorder& recorder, const PlantedTouches& planted) {
  const Vector2 middle{recorder.uniform(-2, 2), recorder.uniform(-2, 2)};
  const Vector2 away = Vector2{1, 0}.turned(recorder.uniform(-3, 3)), own = sum({}, recorder.uniform(0.18, 0.3), away);
  const bool lies = recorder.uniform(0, 1) < 0.5;
  const Vector2 before =
      lies ? Vector2{} : sum({}, -recorder.uniform(0.4, 1), away.turned(recorder.uniform(-0.4, 0.4)));
  Vector2 after =
      rebounded(before, away, planted.robot_restitution, own).turned(planted.push_deviation * recorder.normal());
  if (const double lacks = dot(own, away) - dot(after, away); lacks > 0) after = sum(after, lacks, away);
  recorder.add(sum(middle, 0.15, away), before, after, true, middle, own);
}

}  // namespace

lab::TruthRecord planted_touches(const PlantedTouches& planted, std::uint64_t seed) {
  Recorder recorder(planted, seed);
  for (std::size_t i = 0; i < planted.rebounds; ++i) {
    const Vector2 middle{recorder.uniform(-2, 2), recorder.uniform(-2, 2)};
    const Vector2 away = Vector2{1, 0}.turned(recorder.uniform(-3, 3));
    add_rebound(recorder, middle, 0.15, planted.robot_restitution, away, true);
  }
  for (std::size_t i = 0; i < planted.posts; ++i) {
    const double end = i % 2 == 0 ? 1 : -1, side = i % 4 < 2 ? 1 : -1;
    const Vector2 into = Vector2{-end, 0}.turned(recorder.uniform(-1, 1));
    add_rebound(recorder, {end * 4.5, side * 0.8}, 0.1, planted.post_restitution, into, false);
  }
  for (std::size_t i = 0; i < planted.pushes; ++i) add_push(recorder, planted);
  return std::move(recorder).record();
}

}  // namespace robot::tests
