// All years: in SET nobody moves and the ball lies at the centre. The whistle blows after Rules::set_duration (5 s in
// B-Human's simulated referee). A robot that has moved to an illegal place is placed again.
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
  report(court, Event::Kind::playing, court.book.kicking, kNobody, {});
}

}  // namespace sim::referee::set
