// Walking to places, round robots in the way.
#pragma once

#include "sim/agent/view.h"
#include "sim/motion/command.h"

namespace sim::agent {

/// Walks straight to a place and heading [robot].
inline motion::Command walk_straight(Vec2 target, float heading, float gain) {
  motion::Command command;
  command.body = motion::Command::Body::walk_to;
  command.walk = target, command.turn = heading, command.gain = gain;
  return command;
}
/// Walks to a place and heading [robot], round robots in the way.
motion::Command walk_in_robot(const View& view, Vec2 target, float heading, float gain);
/// Turns on the spot to face `way` [robot]. Stands when it nearly faces it.
motion::Command turn_to(const View& view, Vec2 way);
/// Walks to a place and facing [team_field], round robots in the way. Stands when it is there.
motion::Command walk_to_place(const View& view, Vec2 place, Vec2 face, float gain);

/// Returns a point beside the nearest robot between here and `target` [robot], or `target` when the way is free.
Vec2 round_robots(const View& view, Vec2 target);
/// Returns the next point of a way to `target` that stays `radius` from `centre` [m, robot]. The way goes round the nearer
/// side, or round the other one where the nearer would leave the carpet.
Vec2 round_circle(const View& view, Vec2 centre, float radius, Vec2 target, float side_if_even);

/// Returns the place [m, robot] of a robot that faces `face` and has `ball` where the kick of that leg needs it.
inline Vec2 place_for(const motion::Kick& kick, Vec2 ball, Vec2 face, float side) {
  return ball - kick.ball_x * face - (side * kick.ball_y) * left_of(face);
}
/// Returns the distance [m] that a robot keeps from the ball on its way to have it `ahead` [m] in front.
constexpr float room_of(float ahead) { return ahead + 0.07f < 0.3f ? ahead + 0.07f : 0.3f; }

}  // namespace sim::agent
