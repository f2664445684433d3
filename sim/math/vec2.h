// Points, directions and poses in the plane.
#pragma once

#include <cmath>

#include "sim/math/angles.h"

namespace sim {

/// A point [m], a velocity [m/s] or a direction. The variable's name or comment gives its frame.
struct Vec2 {
  float x = 0;
  float y = 0;

  friend bool operator==(const Vec2&, const Vec2&) = default;
};

constexpr Vec2 operator+(Vec2 a, Vec2 b) { return {a.x + b.x, a.y + b.y}; }
constexpr Vec2 operator-(Vec2 a, Vec2 b) { return {a.x - b.x, a.y - b.y}; }
constexpr Vec2 operator-(Vec2 a) { return {-a.x, -a.y}; }
constexpr Vec2 operator*(float factor, Vec2 a) { return {factor * a.x, factor * a.y}; }
constexpr Vec2& operator+=(Vec2& a, Vec2 b) { return a = a + b; }
constexpr Vec2& operator-=(Vec2& a, Vec2 b) { return a = a - b; }

/// Returns `a` if `first` is true, `b` otherwise, without a branch.
constexpr Vec2 select(bool first, Vec2 a, Vec2 b) { return {first ? a.x : b.x, first ? a.y : b.y}; }
constexpr float dot(Vec2 a, Vec2 b) { return a.x * b.x + a.y * b.y; }
/// Returns a value > 0 when `b` is counter-clockwise of `a`.
constexpr float cross(Vec2 a, Vec2 b) { return a.x * b.y - a.y * b.x; }
constexpr float squared(float x) { return x * x; }
constexpr float squared_length(Vec2 a) { return dot(a, a); }
inline float length(Vec2 a) { return std::sqrt(dot(a, a)); }
inline float distance(Vec2 a, Vec2 b) { return length(b - a); }

/// Returns the unit vector at `angle` [rad] from +x.
inline Vec2 direction(float angle) {
  const SinCos both = sin_cos(angle);
  return {both.cos, both.sin};
}
/// Does the same, but faster when |angle| <= π/4.
inline Vec2 direction_of_small(float angle) {
  if (std::fabs(angle) > kPi / 4) return direction(angle);
  const SinCos both = detail::sin_cos_of_rest(angle, 0);
  return {both.cos, both.sin};
}
/// Returns the angle from +x in (-π, π] rad, and 0 for the zero vector.
inline float angle_of(Vec2 a) { return atan2(a.y, a.x); }
/// Returns `a` turned by the angle of the unit vector `facing`: from the frame that
/// faces that way into its parent frame.
constexpr Vec2 turned(Vec2 a, Vec2 facing) {
  return {a.x * facing.x - a.y * facing.y, a.x * facing.y + a.y * facing.x};
}
/// Returns the inverse of `turned`.
constexpr Vec2 turned_back(Vec2 a, Vec2 facing) {
  return {a.x * facing.x + a.y * facing.y, a.y * facing.x - a.x * facing.y};
}

/// A position and a heading. As a transform it leads from the frame of the pose into its parent frame.
struct Pose2 {
  Vec2 position;
  float heading = 0;  // [rad] (-π, π]

  friend bool operator==(const Pose2&, const Pose2&) = default;
};

}  // namespace sim
