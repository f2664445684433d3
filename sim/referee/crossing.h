// The place and the way in which the ball left the field.
#pragma once

#include <algorithm>

#include "sim/referee/court.h"

namespace sim::referee {

/// The ball's crossing of a line from inside to outside.
struct Crossing {
  bool goal_line;   // over a goal line, not a touch line
  bool from_field;  // it was inside before: a ball that comes from behind a goal is no goal
  bool between_posts;
  float end;   // ±1: sign of x of the nearer goal line
  float line;  // ±1: sign of y of the nearer touch line
  Vec2 at;     // [m, field] ball at the moment when the whole of it was over the line
};

inline bool ball_is_out(const Court& court) {
  return !field::inside_field(court.field, court.world.ball.position, court.ball_model.radius);
}

/// Returns the first line that the ball crossed since the last tick. The ball must be out.
inline Crossing crossing_of(const Court& court) {
  const Vec2 from = court.book.ball_before;
  const Vec2 to = court.world.ball.position;
  // share of the way at which a coordinate passed its limit; 2: never
  const auto share = [](float begin, float end, float limit) {
    if (end <= limit) return 2.f;
    return begin < limit ? (limit - begin) / (end - begin) : 0.f;
  };
  const float end = to.x < 0 ? -1.f : 1.f, line = to.y < 0 ? -1.f : 1.f;
  const float over_end = share(end * from.x, end * to.x, ball_over_goal_line(court));
  const float over_line = share(line * from.y, line * to.y, ball_over_touch_line(court));
  const Vec2 at = from + std::min(over_end, over_line) * (to - from);
  return {
      .goal_line = over_end <= over_line,
      .from_field = std::abs(from.x) <= ball_over_goal_line(court) && std::abs(from.y) <= ball_over_touch_line(court),
      .between_posts = std::abs(at.y) < court.field.goal_width / 2,
      .end = end,
      .line = at.y < 0 ? -1.f : 1.f,
      .at = at};
}

/// Returns the side that defends the goal line which the ball crossed, or the nearer one.
inline Side defender_of(const Court& court, const Crossing& crossing) {
  return crossing.end * court.world.home_attacks > 0 ? Side::away : Side::home;
}

}  // namespace sim::referee
