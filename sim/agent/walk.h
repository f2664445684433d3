// Walking to places, round whoever stands in the way.
#pragma once

#include "sim/agent/view.h"
#include "sim/motion/command.h"

namespace sim::agent {

/// walk_to a place and heading in the frame robot, as it is.
inline motion::Command walk_straight(Vec2 target, float heading, float gain) {
  motion::Command command;
  command.body = motion::Command::Body::walk_to;
  command.walk = target, command.turn = heading, command.gain = gain;
  return command;
}
/// Likewise, but round robots on the way.
motion::Command walk_in_robot(const View& view, Vec2 target, float heading, float gain);
/// Turns on the spot until it faces `way` [robot]; stands when it nearly does.
motion::Command turn_to(const View& view, Vec2 way);
/// To a place and facing [team_field], round robots on the way; stands once it is there.
motion::Command walk_to_place(const View& view, Vec2 place, Vec2 face, float gain);

/// A step aside for what stands between here and `target` [robot]; `target` where nothing does.
Vec2 round_robots(const View& view, Vec2 target);
/// The next point on the way to `target` that stays `radius` from `centre`; all [m, robot].
Vec2 round_circle(Vec2 centre, float radius, Vec2 target, float side_if_even);

}  // namespace sim::agent
