// All years: until the ball of a kick-off is free, the other side stays out of the centre circle.
// Since 2018 it also keeps 0.75 m away from the ball of a set play. A robot that stands there has time to leave, and is
// removed after that.
#pragma once

#include "sim/referee/court.h"

namespace sim::referee::illegal_position {

// [s] an estimate, because the rule book names no time: twice the time that 0.75 m take at walking speed
inline constexpr float kTimeToLeave = 10;

/// Reports whether the side that does not kick must have left by now.
inline bool time_to_leave_is_up(const Court& court) {
  return court.book.set_play == SetPlay::kick_off || in_phase(court) >= ticks(kTimeToLeave);
}

inline bool due(const Court& court, int robot) {
  const Book& book = court.book;
  if (book.ball_free || side_of(robot) == book.kicking || !time_to_leave_is_up(court)) return false;
  const float clear = court.rules.clear_distance;
  return squared_length(court.world.bodies[robot].position - court.world.ball.position) < clear * clear;
}

inline void apply(Court& court, int robot) { remove_robot(court, robot, Event::Kind::illegal_position); }

}  // namespace sim::referee::illegal_position
