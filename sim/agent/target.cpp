#include "sim/agent/target.h"

#include <cmath>

#include "sim/agent/features.h"

namespace sim::agent {
namespace {

constexpr float kNextToBall = 0.35f;     // [m]
constexpr float kUseOfTolerance = 0.7f;  // share of the tolerance that the approach uses; noise needs the rest

/// Returns about the unit vector at an angle >= 0: 0.5 % off at 1 rad, quicker than the exact one, length exactly 1.
Vec2 about(float angle) {
  const float tangent = 0.5f * angle * (1 + angle * angle / 12);
  const float square = tangent * tangent;
  const float scale = 1 / (1 + square);
  return {(1 - square) * scale, 2 * tangent * scale};
}

}  // namespace

Target target_of(const View& view, const Where& where, float lead) {
  const Vec2 ball = view.ball_in_team;
  if (is_given(where.direction)) return {ball + direction(where.direction)};
  if (is_given(where.x)) return {{where.x, where.y}};
  switch (where.aim) {
    case Aim::goal: return {view.goal()};
    case Aim::opening: {
      const Gap gap = widest_gap(view);
      return {{view.half_length, 0.5f * (gap.right + gap.left)}, 0.35f * (gap.left - gap.right)};
    }
    case Aim::away: return {ball + (ball - view.own_goal())};
    case Aim::mate:
      if (const int mate = pass_target(view).mate; mate >= 0)
        return {view.beliefs.mates[mate].pose.position + Vec2{lead, 0}};
      break;
    case Aim::cross: return {{view.half_length - view.around.rules->field.penalty_mark, 0}};
    case Aim::ahead: break;
  }
  return {ball + Vec2{1, 0}};
}

Sector sector_of(const View& view, const Target& target, float tolerance) {
  const Vec2 to_target = target.point - view.ball_in_team;
  const float far = length(to_target);
  const Vec2 straight = far > 1e-3f ? turned_back((1 / far) * to_target, view.facing) : Vec2{1, 0};
  // the angle of the slack, approximated for a goal seen obliquely
  const float slack = far > 0.1f ? target.slack * std::abs(to_target.x) / (far * far) : 0;
  const float allowed = slack > tolerance ? (slack < 1.2f ? slack : 1.2f) : tolerance;
  return {straight, about(kUseOfTolerance * allowed), about(allowed).x};
}

Vec2 way_in(const Sector& sector, const View& view, Vec2 bend) {
  // next to the ball the heading counts, farther away the direction to the ball, which the robot will face
  const Vec2 coming = view.ball_distance > kNextToBall ? (1 / view.ball_distance) * view.ball : Vec2{1, 0};
  const Vec2 goes = turned(coming, bend);
  if (dot(goes, sector.straight) >= sector.use.x) return goes;
  const float across = cross(sector.straight, goes);
  const float side = across != 0 ? sign(across) : view.mind.search_side;
  return turned(sector.straight, {sector.use.x, side * sector.use.y});
}

}  // namespace sim::agent
