// Contacts between robots, posts, the walking referee and the ball.
#pragma once

#include "sim/field/field.h"
#include "sim/world/crowd.h"
#include "sim/world/effects.h"
#include "sim/world/model.h"
#include "sim/world/world.h"

namespace sim {

/// Pushes overlapping robots apart, each by half of the overlap, and pushes robots out of posts and the walking
/// referee. Counts for how long each body has touched another one and has run into it.
/// Afterwards no two bodies on the field overlap by more than 1 mm, and no body overlaps a post by more than that.
/// The result does not depend on the order of robots. The one exception: of two at exactly the same place, the first
/// one moves towards -x. `crowd` must match `world`; the function keeps it so. Reports whether any body has begun to touch
/// another one.
bool keep_bodies_apart(const field::Field& field, const ContactModel& contact, Crowd& crowd, World& world);

/// The collisions of each robot, by its index.
struct AllCollisions {
  /// [m/s, robot] at which others close in on it, the way in which it is pushed: the sum over those that it meets
  Vec2 closing[kMaxRobots];
};

/// Returns the collisions of this tick: of two bodies that touch after `keep_bodies_apart`, at least one of which touched nobody
/// before. The result does not depend on the order of robots.
AllCollisions collisions_of(const ContactModel& contact, const World& world);

/// Bounces the ball off bodies and posts. Call it once a tick, after `roll`.
///
/// A standing body or a post throws the ball back. A walking body pushes it along, at least at the body's own speed
/// towards the ball. A thing that stands still never makes the ball faster. The ball passes through nothing in this
/// tick, whatever its speed.
/// Sets `world.touched` to the robot that touched the ball last; of two at once see `is_named_before`.
/// A duel is two walking robots of opposite sides that push the ball at once. While it lasts, the effect duels lets the
/// ball leave across the line of both, `duel_rate` times a second.
/// Draws push_noise and duel (of nobody; number: tick). `crowd` must match `world`.
void bounce_ball(const field::Field& field, const BallModel& ball, const ContactModel& contact, const Effects& effects,
                 const Crowd& crowd, World& world);

/// Moves the walking referee for one tick, at 1 m/s at most: it keeps 1.5 m away from the ball. It starts on the long
/// axis of the field, in the half that Draw::official selects.
void walk_official(const field::Field& field, World& world);

}  // namespace sim
