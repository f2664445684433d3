// 2012: a ball that went out is put on the throw-in line, which runs inside the touch line, and play goes on.
//   - Out over a touch line: one metre back from there, towards the goal of the side that put it out.
//   - Out over a goal line, by a defender: at the end of the throw-in line next to the corner.
//   - Out over a goal line, by an attacker: at the halfway line, or one metre back from the last touch if that is
//     farther back.
#pragma once

#include "sim/referee/crossing.h"

namespace sim::referee::placed_back {

// [m] from the goal line to the end of the throw-in lines (B-Human's fieldDimensions: 3.5 m of 4.5 m)
inline constexpr float kEnd = 1;

inline bool due(const Court& court, const Crossing&) { return court.rules.ball_out == field::BallOut::placed_back; }

inline void apply(Court& court, const Crossing& crossing) {
  const Side side = court.book.last_touch;
  const float back = court.rules.out_set_back;
  const float corner = court.field.length / 2 - kEnd;

  // how far ahead of the centre, from the view of `side`
  float place = ahead(court, side, crossing.at) - back;
  if (crossing.goal_line) {
    const bool defended = defender_of(court, crossing) == side;
    place = defended ? -corner : std::min(0.f, ahead(court, side, court.book.last_touch_at) - back);
  }
  place = std::clamp(place, -corner, corner);

  report(court, Event::Kind::out, side, court.book.last_toucher, crossing.at);
  place_ball(court,
             {attack_sign(court.world, side) * place, crossing.line * (court.field.width / 2 - court.rules.out_inset)});
}

}  // namespace sim::referee::placed_back
