// All years: at the end of a half the sides change and the other side kicks off; after the last half the game is over.
// The clock starts with the first PLAYING of a half and, as in preliminary rounds, does not stop again. Penalties end
// at half time.
#pragma once

#include "sim/referee/court.h"

namespace sim::referee::half_time {

/// Counts this tick. Call it once a tick.
inline void run_clock(Book& book) {
  if (book.phase == Phase::playing || book.clock > 0) ++book.clock;
}

inline bool due(const Court& court) { return court.book.clock >= ticks(court.rules.half_duration); }

inline void apply(Court& court) {
  Book& book = court.book;
  if (book.half >= court.rules.halves) return finish(court);
  report(court, Event::Kind::half_time, Side::home, kNobody, court.world.ball.position);
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
