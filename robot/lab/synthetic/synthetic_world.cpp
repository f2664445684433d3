#include "robot/lab/synthetic/synthetic_world.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace robot::lab::synthetic {
namespace {

constexpr double kPi = std::numbers::pi;

// two walks together make the whole circle; their speed rises and falls within kRamp, the second is half-way at kKick
constexpr Point kCircleCentre{-1.5, 0.4};
constexpr double kCircleRadius = 0.8;  // [m]
constexpr double kRamp = 0.5;          // [s]
constexpr double kWalkSpeed = 2 * kPi * kCircleRadius / (kSet - kReady - kRamp + kSetAgain - kPlaying - kRamp);

constexpr double kFriction = 0.4;                // [m/s²]
constexpr Point kPassTarget{-1.3, -0.4};         // end of the pass, a step in front of 14/2 at kKick
constexpr Point kShotTarget{4.6, 0.15};          // within the goal
constexpr double kShotSpeed = 2.3;               // [m/s]
constexpr double kNet = kFieldLength / 2 + 0.4;  // [m] x at which the net stops the ball

struct Walk {
  double distance, speed;
};

/// Returns the progress of a walk from `start` to `end` [s].
Walk walk(double t, double start, double end) {
  const auto ramp = [](double since) {  // the integral of a speed that rises to 1 within kRamp
    const double rising = std::clamp(since, 0.0, kRamp);
    return rising * rising / (2 * kRamp) + std::max(0.0, since - kRamp);
  };
  const double rise = std::clamp((t - start) / kRamp, 0.0, 1.0), fall = std::clamp((t - end + kRamp) / kRamp, 0.0, 1.0);
  return {kWalkSpeed * (ramp(t - start) - ramp(t - end + kRamp)), kWalkSpeed * (rise - fall)};
}

/// Returns a ball `t` seconds after it left `from` towards `to` with `speed`.
RollingBall roll(Point from, Point to, double speed, double t) {
  const double length = std::hypot(to.x - from.x, to.y - from.y);
  const Point direction{(to.x - from.x) / length, (to.y - from.y) / length};
  const double rolling = std::min(t, speed / kFriction);
  const double way = speed * rolling - kFriction * rolling * rolling / 2, now = speed - kFriction * rolling;
  return {{from.x + way * direction.x, from.y + way * direction.y}, {now * direction.x, now * direction.y}, way};
}

}  // namespace

Point relative(Point p, Point origin, double heading) {
  const double c = std::cos(heading), s = std::sin(heading), x = p.x - origin.x, y = p.y - origin.y;
  return {c * x + s * y, c * y - s * x};
}

double normalised(double angle) {
  const double turned = std::remainder(angle, 2 * kPi);
  return turned <= -kPi ? kPi : turned;
}

Walker walker_at(double t) {
  const Walk first = walk(t, kReady, kSet), second = walk(t, kPlaying, kSetAgain);
  const double distance = first.distance + second.distance, speed = first.speed + second.speed;
  const double angle = kPi / 2 + distance / kCircleRadius;
  return {{kCircleCentre.x + kCircleRadius * std::cos(angle), kCircleCentre.y + kCircleRadius * std::sin(angle)},
          normalised(angle + kPi / 2),
          speed,
          speed / kCircleRadius,
          distance};
}

std::optional<RollingBall> ball_at(double t) {
  if (t >= kTakenAway && t < kPutBack) return std::nullopt;
  if (t < kPlaying || t >= kPutBack) return RollingBall{};
  if (t < kKick) {
    const double pass = std::hypot(kPassTarget.x, kPassTarget.y);
    return roll({}, kPassTarget, std::sqrt(2 * kFriction * pass), t - kPlaying);
  }
  RollingBall ball = roll(kPassTarget, kShotTarget, kShotSpeed, t - kKick);
  if (ball.position.x > kNet) ball = {{kNet, kShotTarget.y}, {}, ball.rolled};
  return ball;
}

std::vector<OtherRobot> others_at(double t) {
  const double sway = std::min(t, kEnd);
  // before the kick-off only 14/3 is near the ball; then the opponents approach
  const double advance = std::clamp((t - kPlaying) / 6, 0.0, 1.0);
  return {{14, 1, {-4.3, 0.1 * std::sin(sway)}, 0},
          {14, 3, {0.25 + 0.8 * advance, 0.05 + 0.9 * advance}, normalised(kPi - 0.8 * advance)},
          {5, 1, {4.3, 0.3 * std::sin(0.8 * sway)}, kPi},
          {5, 2, {1.6 - 0.7 * advance, -1.2 + 0.3 * advance}, kPi},
          {5, 3, {2.0, 1.3 + 0.2 * std::sin(0.6 * sway)}, kPi}};
}

}  // namespace robot::lab::synthetic
