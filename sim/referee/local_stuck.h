// All years: when the ball has not got away from several robots round it for Rules::stuck_local, the robot nearest to
// it is removed. If several are at exactly the same distance, all of them are removed, so the order of robots does not
// matter.
#pragma once

#include "sim/referee/court.h"

namespace sim::referee::local_stuck {

inline constexpr float kAway = 0.5f;    // [m] way after which the ball has got away
inline constexpr float kRound = 0.75f;  // [m] greatest distance of a robot round the ball (estimate)
inline constexpr int kSeveral = 2;      // robots round the ball

inline float squared_distance_to_ball(const Court& court, int robot) {
  return squared_length(court.world.bodies[robot].position - court.world.ball.position);
}

inline bool several_are_round(const Court& court) {
  int round = 0;
  for_each_robot(court.world.players, [&](int robot) {
    round += on_field(court, robot) && squared_distance_to_ball(court, robot) < kRound * kRound;
  });
  return round >= kSeveral;
}

/// Notes since when the ball has hardly moved with several robots round it. Call it with each check of the robots.
inline void watch(Court& court) {
  Book& book = court.book;
  const Vec2 ball = court.world.ball.position;
  if (!book.ball_free) return;
  const bool away = squared_length(ball - book.stuck_at) >= kAway * kAway;
  if (!away && several_are_round(court)) return;
  book.stuck_at = ball;
  book.stuck_since = court.world.tick;
}

inline bool due(const Court& court) {
  return court.book.ball_free && court.rules.stuck_local > 0 &&
         court.world.tick - court.book.stuck_since >= ticks(court.rules.stuck_local);
}

inline void apply(Court& court) {
  float nearest = kRound * kRound;
  for_each_robot(court.world.players, [&](int robot) {
    const float distance = squared_distance_to_ball(court, robot);
    if (on_field(court, robot) && distance < nearest) nearest = distance;
  });
  for_each_robot(court.world.players, [&](int robot) {
    const bool is_nearest = on_field(court, robot) && squared_distance_to_ball(court, robot) == nearest;
    if (is_nearest) remove_robot(court, robot, Event::Kind::local_stuck);
  });
  court.book.stuck_since = court.world.tick;
}

}  // namespace sim::referee::local_stuck
