// All years: the ball of a kick-off is free for the opponents once the kicking side has touched it, or 10 s later.
// Since 2018: likewise the ball of a set play, 30 s later.
#pragma once

#include "sim/referee/court.h"

namespace sim::referee::ball_free {

inline bool due(const Court& court) {
  const Book& book = court.book;
  if (book.ball_free) return false;
  if (court.world.touched != kNobody && side_of(court.world.touched) == book.kicking) return true;
  const bool kick_off = book.set_play == SetPlay::kick_off;
  return in_phase(court) >= ticks(kick_off ? court.rules.kick_off_duration : court.rules.set_play_duration);
}

inline void apply(Court& court) {
  Book& book = court.book;
  report(court, Event::Kind::ball_free, book.kicking, court.world.touched, court.world.ball.position);
  begin_phase(court, Phase::playing);
  const bool kick_off = book.set_play == SetPlay::kick_off && court.world.touched != kNobody;
  if (kick_off && !court.rules.kick_off_goal) book.kick_off_by = court.world.touched;
  book.ball_free = true;
  book.set_play = SetPlay::none;
  book.last_touch_tick = court.world.tick;
  book.stuck_since = court.world.tick;
}

}  // namespace sim::referee::ball_free
