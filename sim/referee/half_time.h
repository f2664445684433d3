// All years: when the time of a half is up, sides change and the other side kicks off; after the last half the game is
// over. The clock runs from the first `playing` of a half and, as in preliminary rounds, never stops again. Penalties
// do not outlast the break.
#pragma once

#include "sim/referee/court.h"

namespace sim::referee::half_time {

/// Counts this tick; call it once a tick.
inline void run_clock(Book& book) {
  if (book.phase == Phase::playing || book.clock > 0) ++book.clock;
}

inline bool due(const Court& court) { return court.book.clock >= ticks(court.rules.half_duration); }

inline void apply(Court& court) {
  Book& book = court.book;
  if (book.half >= court.rules.halves) return finish(court);
  tell(court, Event::Kind::half_time, Side::home, kNobody, court.world.ball.position);
  ++book.half;
  book.clock = 0;
  court.world.home_attacks = -court.world.home_attacks;
  for_each_robot(court.world.players, [&](int robot) {
    book.penalised_until[robot] = 0;
    put_at_touch_line(court, robot, touch_line_of(court.world.bodies[robot]));
  });
  const Side kicking = book.half % 2 == 0 ? other(book.first_kick_off) : book.first_kick_off;
  begin_kick_off(court, kicking, court.world.tick);
}

}  // namespace sim::referee::half_time
