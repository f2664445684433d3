// Where the ball left the field.
#pragma once

#include <algorithm>

#include "sim/referee/court.h"

namespace sim::referee {

/// How the ball went from inside the lines to outside.
struct Crossing {
  bool goal_line;   // over a goal line rather than a touch line
  bool from_field;  // it was inside before: a ball that comes from behind a goal is no goal
  bool between_posts;
  float end;   // ±1: the sign of x of the goal line nearer to it
  float line;  // ±1: the sign of y of the touch line nearer to it
  Vec2 at;     // [m, field] the ball when it was just wholly over the line
};

inline bool ball_is_out(const Court& court) {
  return !field::inside_field(court.field, court.world.ball.position, court.ball_model.radius);
}

/// Of a ball that is out: the first line that it crossed since the last tick.
inline Crossing crossing_of(const Court& court) {
  const Vec2 from = court.book.ball_before;
  const Vec2 to = court.world.ball.position;
  // share of the way at which a coordinate passed its limit; 2: it did not
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

/// The side that defends the goal line which the ball crossed or was nearer to.
inline Side defender_of(const Court& court, const Crossing& crossing) {
  return crossing.end * court.world.home_attacks > 0 ? Side::away : Side::home;
}

}  // namespace sim::referee
