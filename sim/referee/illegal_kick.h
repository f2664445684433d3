// All years: until the ball of a kick-off or set play is free, only the kicking side may touch it. After a touch by the
// other side, the ball is put back and the robot is removed, unless it still has time to leave.
#pragma once

#include "sim/referee/illegal_position.h"

namespace sim::referee::illegal_kick {

inline bool due(const Court& court) {
  const std::uint8_t robot = court.world.touched;
  return !court.book.ball_free && robot != kNobody && side_of(robot) != court.book.kicking;
}

inline void apply(Court& court) {
  const int robot = court.world.touched;
  place_ball(court, court.book.stuck_at);
  court.book.last_touch = court.book.kicking;
  if (illegal_position::time_to_leave_is_up(court)) remove_robot(court, robot, Event::Kind::illegal_kick);
}

}  // namespace sim::referee::illegal_kick
