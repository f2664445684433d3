#include "sim/referee/counts.h"

#include <algorithm>

namespace sim::referee {

bool rolls_into_goal(const Court& court, Side side) {
  const Vec2 from = court.world.ball.position;
  const Vec2 to = resting_place(court.world.ball, court.ball_model.deceleration);
  const float line = ball_over_goal_line(court);
  // the ball is over the line already: it crosses the line at its present place
  if (ahead(court, side, from) > line)
    return ahead(court, side, to) > line && std::abs(from.y) < court.field.goal_width / 2;
  return field::goal_entered(court.field, from, to, court.ball_model.radius) == attack_sign(court.world, side);
}

void keep_counts(Court& court) {
  const World& world = court.world;
  Book& book = court.book;
  GameCounts& counts = court.counts;

  if (world.touched != kNobody) {
    const float circle = court.field.centre_circle_radius;
    const bool outside = squared_length(world.ball.position) > circle * circle;
    if (world.touched != book.kick_off_by || outside) book.kick_off_by = kNobody;
    book.last_toucher = world.touched;
    book.last_touch = side_of(world.touched);
    book.last_touch_tick = world.tick;
    book.last_touch_at = world.ball.position;
  }
  if (world.kicked != kNobody) {
    const Side side = side_of(world.kicked);
    ++counts.kicks[static_cast<int>(side)];
    if (rolls_into_goal(court, side)) ++counts.shots[static_cast<int>(side)];
  }
  if (world.whiffed != kNobody) ++counts.whiffs[static_cast<int>(side_of(world.whiffed))];

  ++counts.in_play;
  if (book.last_toucher != kNobody) ++counts.possession[static_cast<int>(book.last_touch)];
}

}  // namespace sim::referee
