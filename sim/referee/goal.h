// All years: a goal is scored when the whole ball passes over the goal line between the posts. The other side kicks
// off; as in preliminary rounds, the clock runs on. A ball directly from a kick-off is no goal but a ball that went
// out. Since 2019 the robots receive the report late (Rules::goal_message_delay), so that they detect goals themselves.
#pragma once

#include "sim/referee/crossing.h"

namespace sim::referee::goal {

inline bool due(const Court& court, const Crossing& crossing) {
  const bool allowed = court.book.kick_off_by == kNobody;
  return crossing.goal_line && crossing.from_field && crossing.between_posts && allowed;
}

inline void apply(Court& court, const Crossing& crossing) {
  const Side scorer = other(defender_of(court, crossing));
  ++court.book.score[static_cast<int>(scorer)];
  report(court, Event::Kind::goal, scorer, court.book.last_toucher, crossing.at);
  begin_kick_off(court, other(scorer), court.world.tick + ticks(court.rules.goal_message_delay));
}

}  // namespace sim::referee::goal
