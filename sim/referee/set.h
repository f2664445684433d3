// All years: in set nobody moves and the ball lies at the centre; some seconds later (B-Human's simulated referee: 5)
// the whistle blows. Whoever moved to where it must not be meanwhile is placed again.
#pragma once

#include "sim/referee/in_set.h"

namespace sim::referee::set {

inline bool due(const Court& court) {
  return court.book.phase == Phase::set && in_phase(court) >= ticks(court.rules.set_duration);
}

inline void apply(Court& court) {
  for_each_robot(court.world.players, [&](int robot) {
    if (in_set::due(court, robot)) in_set::apply(court, robot);
  });
  begin_phase(court, Phase::playing);
  place_ball(court, {});
  tell(court, Event::Kind::playing, court.book.kicking, kNobody, {});
}

}  // namespace sim::referee::set
