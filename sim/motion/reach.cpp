#include <algorithm>
#include <cmath>

#include "sim/motion/walk.h"

namespace sim::motion {
namespace {

constexpr float kHalfTurn = 0.5f * kPi;

// [s] for a way that begins and ends at rest: speed up, keep `top`, slow down and be content `within` of the end
float duration_of(float way, float top, float acceleration, float brake, float within) {
  if (way <= within) return 0;
  const float both = 1 / acceleration + 1 / brake;
  const bool reaches_top = way >= 0.5f * top * top * both;
  const float whole = reaches_top ? way / top + 0.5f * top * both : std::sqrt(2 * way * both);
  return whole - std::sqrt(2 * within / brake);
}

// [m/s] at most, walking `angle` off the facing
float top_speed_at(const Walk& walk, float angle) {
  const float quarters = std::abs(angle) / kHalfTurn;
  if (quarters <= 1) return walk.forward + quarters * (walk.sideward - walk.forward);
  return walk.sideward + std::min(1.f, quarters - 1) * (walk.backward - walk.sideward);
}

float wrapped(float angle) { return angle > kPi ? angle - 2 * kPi : angle < -kPi ? angle + 2 * kPi : angle; }

}  // namespace

float time_to_reach(const Walk& walk, Vec2 target, float heading) {
  heading = wrapped(heading);
  float left = length(target);
  if (left <= kArrived && std::abs(heading) <= kArrivedTurn) return 0;
  const float bearing = angle_of(target);
  const auto turning_time = [&](float angle) {
    return duration_of(angle, walk.turn_rate, walk.turn_acceleration, kBrakes * walk.turn_acceleration, kArrivedTurn);
  };
  const float share = 1 - walk.turn_cost;
  float time = walk.start_delay;

  // far away: turn to the destination, coming nearer once it is ahead, then walk up to it; or be near before it faced it
  float turned = 0;
  if (left > kNear) {
    const float whole = std::abs(bearing);
    const float turning = turning_time(whole);
    const float full_rate = whole / walk.turn_rate;
    const float ahead = std::min(full_rate, 1 / walk.turn_rate);
    const float nearer = walk.forward * std::max(0.f, share * ahead + 0.5f * (turning - full_rate));
    const float way = left - kNear;
    turned = whole;
    if (nearer > way) {
      const float behind = std::max(0.f, whole - kHalfTurn);
      turned = behind + std::sqrt(way / nearer) * (whole - behind);
      time += turning * turned / whole;
    } else {
      time += turning + (way - nearer) / walk.forward;
    }
    turned = std::copysign(turned, bearing);
    left = kNear;
  }

  // near it: turn to the heading while walking on, at the speed of that direction
  const float turn = wrapped(heading - turned);
  const float turning = turning_time(std::abs(turn));
  const float nearer = share * turning * top_speed_at(walk, bearing - turned - 0.5f * turn);
  const float top = top_speed_at(walk, wrapped(bearing - turned - turn));
  const float rest = std::max(0.f, left - nearer);
  return time + turning + duration_of(rest, top, walk.acceleration, brake_of(walk), kArrived);
}

}  // namespace sim::motion
