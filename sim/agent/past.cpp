#include "sim/agent/past.h"

namespace sim::agent {
namespace {

constexpr float kAhead = 1.5f;   // [m] opponents farther in front of the ball are ignored
constexpr float kInside = 0.1f;  // [m] the ball stays this far inside the touch lines
constexpr float kSpare = 1.02f;  // the way stays this factor wider than the room, because beliefs move
constexpr float kEven = 1e-4f;   // [m] an opponent this near to the line has no side

}  // namespace

Vec2 past_nearest(const View& view, Vec2 way, float room) {
  const Vec2 ball = view.ball;
  float least = kAhead * kAhead;
  Vec2 nearest;
  view.for_each_opponent([&](Vec2 opponent) {
    const Vec2 offset = view.to_robot(opponent) - ball;
    const float far = squared_length(offset), off = cross(way, offset);
    if (far < least && dot(way, offset) > 0 && off * off < room * room) nearest = offset, least = far;
  });
  if (nearest == Vec2{}) return way;

  // along the tangent of the circle round it
  const float far = length(nearest);
  const Vec2 to_it = (1 / far) * nearest;
  const float sine = kSpare * room < far ? kSpare * room / far : 1;
  const float cosine = std::sqrt(1 - sine * sine);
  const auto tangent = [&](float side) { return cosine * to_it + (side * sine) * left_of(to_it); };
  const float off = cross(nearest, way);
  const float side = std::abs(off) > kEven ? sign(off) : static_cast<float>(view.mind.search_side);
  const float passes = view.ball_in_team.y + far * turned(tangent(side), view.facing).y;
  return tangent(std::abs(passes) > view.half_width - kInside ? -side : side);
}

}  // namespace sim::agent
