// All years: at the end of its penalty a removed robot comes back at the touch line farther from the ball. It stands
// level with its own penalty mark and faces across the field.
#pragma once

#include "sim/referee/court.h"

namespace sim::referee::returning {

// [m] gap between two robots that come back side by side (estimate)
inline constexpr float kGap = 0.1f;

inline bool due(const Court& court, int robot) {
  const Tick until = court.book.penalised_until[robot];
  return until != 0 && until <= court.world.tick;
}

/// Reports whether any robot waits beside the field. It is fast, because it runs in every tick.
inline bool somebody_waits(const Court& court) {
  Tick any = 0;
#pragma GCC unroll 14
  for (int robot = 0; robot < kMaxRobots; ++robot) any |= court.book.penalised_until[robot];
  return any != 0;
}

/// Reports whether the robot would touch no other robot on the field at this place.
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

  // when the place is taken: one step towards the own goal, one towards the halfway line, then two steps, and so on
  const float own_half = -attack_sign(court.world, side_of(robot));
  const float step = 2 * court.contact.robot_radius + kGap;
  const float mark = court.field.length / 2 - court.field.penalty_mark;
  Vec2 at{own_half * mark, line * court.field.width / 2};
  for (int aside = 1; aside <= kMaxRobots && !is_vacant(court, robot, at); ++aside) {
    const int steps = (aside + 1) / 2;
    const float shift = step * static_cast<float>(steps);
    at.x = own_half * (aside % 2 == 1 ? mark + shift : mark - shift);
  }

  put_robot(court, robot, at, {0, -line}, -line * kPi / 2);
  court.book.penalised_until[robot] = 0;
  report(court, Event::Kind::returned, side_of(robot), robot, at);
}

}  // namespace sim::referee::returning
