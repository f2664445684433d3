// The motion controller: commands → bodies.
#pragma once

#include <span>
#include <string_view>

#include "sim/math/tick.h"
#include "sim/motion/command.h"
#include "sim/motion/model.h"
#include "sim/world/effects.h"
#include "sim/world/model.h"
#include "sim/world/world.h"

namespace sim::motion {

/// The parameters of motion. They are constant during a game.
struct MotionParams {
  const Model& model;
  const Effects& effects;
  const BallModel& ball;
};

/// The move of one robot. The head moves after the body, for `head_steps` ticks.
struct Mover {
  const Command* command;
  const Pose2* told;  // [field] the robot's pose when it got the command; for the head only
  World* world;
  int robot;
  Tick steps;       // of the body, from world->tick on
  Tick head_steps;  // 0: the head does not move
};

/// Moves robots with the same model, of one game or of several: walk, kick, squat, fall and get up, then the head. The
/// robots of one game are in the order of their indices. The result is the same as from one call for each robot.
///
/// A body is never faster than its model's speeds. One call with many ticks ends where many single ticks end.
///
/// A body finishes a walking step that has begun. It obeys a new command to the legs when the next step begins, or at
/// once when it is in no step. Real walking engines settle the size of a step when it begins, too.
///
/// The destination of walk_to is relative to the pose at the time of the call, so the caller passes the remaining way
/// with each call. Farther than 0.4 m away the body turns to the destination and walks ahead. Nearer it walks in any
/// direction while it turns to its final heading. It stops within 1 cm and 2°.
///
/// Nothing interrupts a kick or a squat. The foot reaches the ball in the tick that begins `delay` after the command. A
/// hit sets the ball's velocity, `world.kicked` and `world.touched`; a miss sets `world.whiffed`. The caller clears
/// these in each tick. After a kick the body walks on without delay. A fallen body
/// ignores commands and gets up by itself.
///
/// The effect walk_acceleration includes the cost of turning and the slowing down before a destination. Draws
/// walk_noise (number: index of the walking step), kick_noise, fall and get_up (number: tick), and servos.
///
/// The head aims at a point within 0.02 rad. Where yaw and pitch together would touch a shoulder, the pitch is limited
/// and the yaw waits for it. The head of a body on the ground does not move.
void move(const MotionParams& params, std::span<const Mover> movers);

/// Lets a robot fall, perhaps, in the collisions of this tick. `closing` [m/s, robot] is as in AllCollisions. It does nothing
/// without the effect falls, or if the model has no table of falls, or to a body on the ground. Draws collision (number: tick),
/// and servos.
void topple(const MotionParams& params, Vec2 closing, int robot, World& world);

/// Returns the index of the kick with that name, or -1.
int find_kick(const Model& model, std::string_view name);

}  // namespace sim::motion
