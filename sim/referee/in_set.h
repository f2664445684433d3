// All years: at the kick-off each robot must be in its own half. Robots of the side that does not kick off must be
// outside the centre circle.
// 2012: a robot at an illegal place is placed by hand, without penalty. 2025: it is removed for 15 s. Here it is placed
// in all years, which costs it about as much as the walk back.
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

/// Puts the robot at the nearest legal place, one robot's radius clear of the line.
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
  report(court, Event::Kind::placed, side, robot, at);
}

}  // namespace sim::referee::in_set
