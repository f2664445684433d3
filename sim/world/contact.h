// What happens when things meet: robots, posts, the ball.
#pragma once

#include "sim/field/field.h"
#include "sim/world/effects.h"
#include "sim/world/model.h"
#include "sim/world/world.h"

namespace sim {

/// Pushes robots that overlap apart, each half of the way, and out of posts and the walking referee; counts how long a
/// body has been touching another and running into it. Does not depend on the order of robots.
/// Afterwards no two bodies on the field overlap by more than a millimetre, and none is inside a post.
void keep_bodies_apart(const field::Field& field, const ContactModel& contact, World& world);

/// The ball against bodies and posts: a standing body or a post throws it back, a walking one pushes it along.
/// Sets `world.touched`. Draws from the event push_noise.
void bounce_ball(const field::Field& field, const BallModel& ball, const ContactModel& contact, const Effects& effects,
                 World& world);

/// Moves the walking referee one tick on: it keeps near play and out of its way.
void walk_official(const field::Field& field, World& world);

}  // namespace sim
