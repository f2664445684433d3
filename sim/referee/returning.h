// All years: when its time is up, a removed robot comes back at a touch line, level with its own penalty mark, looking
// across the field; at the touch line farther from the ball.
#pragma once

#include "sim/referee/court.h"

namespace sim::referee::returning {

inline bool due(const Court& court, int robot) {
  const Tick until = court.book.penalised_until[robot];
  return until != 0 && until <= court.world.tick;
}

/// Somebody waits beside the field: quick, as it is asked in every tick.
inline bool somebody_waits(const Court& court) {
  Tick any = 0;
  for_each_robot(court.world.players, [&](int robot) { any |= court.book.penalised_until[robot]; });
  return any != 0;
}

/// Nobody else on the field is so near to `at` that bodies would touch.
inline bool is_vacant(const Court& court, int robot, Vec2 at) {
  const float apart = 2 * court.contact.robot_radius;
  bool vacant = true;
  for_each_robot(court.world.players, [&](int another) {
    if (another == robot || !on_field(court, another)) return;
    vacant &= squared_length(court.world.bodies[another].position - at) >= apart * apart;
  });
  return vacant;
}

inline void apply(Court& court, int robot) {
  const Body& body = court.world.bodies[robot];
  const float ball = court.world.ball.position.y;
  const float line = ball > 0 ? -1.f : ball < 0 ? 1.f : touch_line_of(body);

  // beside whoever stands there already: so far towards the own goal, then as far towards the halfway line, and so on
  const float own_half = -attack_sign(court.world, side_of(robot));
  const float step = 2 * court.contact.robot_radius + 0.1f;
  const float mark = court.field.length / 2 - court.field.penalty_mark;
  Vec2 at{own_half * mark, line * court.field.width / 2};
  for (int aside = 1; aside <= kMaxRobots && !is_vacant(court, robot, at); ++aside) {
    const int steps = (aside + 1) / 2;
    const float shift = step * static_cast<float>(steps);
    at.x = own_half * (aside % 2 == 1 ? mark + shift : mark - shift);
  }

  put_robot(court, robot, at, {0, -line}, -line * kPi / 2);
  court.book.penalised_until[robot] = 0;
  tell(court, Event::Kind::returned, side_of(robot), robot, at);
}

}  // namespace sim::referee::returning
