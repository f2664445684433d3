// All years: at the kick-off a robot must be in its own half, and one of the side that does not kick off outside the
// centre circle. 2012: a robot that is not is placed by hand, without penalty. 2025: it is removed for 15 s; here it
// is placed too, which costs it as much as the walk back to where it was.
#pragma once

#include "sim/referee/court.h"

namespace sim::referee::in_set {

inline bool due(const Court& court, int robot) {
  if (!on_field(court, robot)) return false;
  const Side side = side_of(robot);
  const Vec2 at = court.world.bodies[robot].position;
  const float circle = court.field.centre_circle_radius;
  return ahead(court, side, at) > 0 || (side != court.book.kicking && squared_length(at) < circle * circle);
}

/// To the nearest legal place, one robot's radius clear of the line.
inline void apply(Court& court, int robot) {
  const Side side = side_of(robot);
  const float margin = court.contact.robot_radius;
  Body& body = court.world.bodies[robot];
  Vec2 at = body.position;

  if (ahead(court, side, at) > -margin) at.x = -attack_sign(court.world, side) * margin;
  const float circle = court.field.centre_circle_radius;
  const float from_centre = length(at);
  if (side != court.book.kicking && from_centre < circle) at = ((circle + margin) / from_centre) * at;

  put_robot(court, robot, at, body.facing, body.heading);
  tell(court, Event::Kind::placed, side, robot, at);
}

}  // namespace sim::referee::in_set
