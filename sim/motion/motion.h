// The motion controller: commands → bodies.
#pragma once

#include <string_view>

#include "sim/math/tick.h"
#include "sim/motion/command.h"
#include "sim/motion/model.h"
#include "sim/world/effects.h"
#include "sim/world/model.h"
#include "sim/world/world.h"

namespace sim::motion {

/// What moving depends on; none of it changes during a game.
struct MotionParams {
  const Model& model;
  const Effects& effects;
  const BallModel& ball;
};

/// Moves one body, its head left aside, `steps` ticks on, up to the tick after `world.tick + steps - 1`, as `command`
/// says: walk, kick, squat, falling and getting up. No body is ever faster than its model's speeds; many ticks at once
/// lead where single ones do.
///
/// A step of the walk that has begun is finished: what the legs are told is heeded when the next one begins, or at once
/// by a body that is in no step. So it is with walking engines: the size of a step is settled when it begins.
///
/// walk_to leads to a place seen from where the body stands when this is called: whoever decides tells it again each
/// time, with what is left to go. Farther than 0.4 m away the body turns to the destination and walks ahead; nearer it
/// walks in any direction while turning to the heading it shall have. It stands within 1 cm and 2°.
///
/// A kick, like a squat, is not interrupted. Its foot meets the ball in the tick that begins `delay` later: a hit sets
/// the ball's velocity, `world.kicked` and `world.touched`, a miss `world.whiffed` (whoever steps the world clears
/// these). When it is done the body walks on without delay. Whoever is down ignores commands and gets up by itself.
///
/// Effects: walk_acceleration also stands for what turning costs and for slowing down before a destination. Draws from
/// the events walk_noise (number: index of the walk step), kick_noise, fall and get_up (number: tick).
void move(const MotionParams& params, const Command& command, int robot, Tick steps, World& world);

/// Moves the head for `steps` ticks, at the end of which the body stands where it does. A point, seen from where the
/// body was when it was `told` to look there [field], is looked to within 0.02 rad. Where yaw and pitch together would
/// touch a shoulder, the pitch gives way; the yaw waits for it. Who lies does not move it.
void turn_head(const MotionParams& params, const Command& command, const Pose2& told, Tick steps, Body& body);

/// The kick of that name, or -1.
int find_kick(const Model& model, std::string_view name);

}  // namespace sim::motion
