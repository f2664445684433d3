// What happens when things meet: robots, posts, the ball.
#pragma once

#include "sim/field/field.h"
#include "sim/world/crowd.h"
#include "sim/world/effects.h"
#include "sim/world/model.h"
#include "sim/world/world.h"

namespace sim {

/// Pushes robots that overlap apart, each half of the way, and out of posts and the walking referee; counts how long a
/// body has been touching another and running into it. Does not depend on the order of robots, unless two stand at
/// exactly the same place: then the first goes towards -x.
/// Afterwards no two bodies on the field overlap by more than a millimetre, nor does one overlap a post so much.
/// `crowd` is that of `world`, and still is afterwards.
void keep_bodies_apart(const field::Field& field, const ContactModel& contact, Crowd& crowd, World& world);

/// The ball against bodies and posts: a standing body or a post throws it back, a walking one pushes it along, with at
/// least its own speed towards the ball. Nothing that stands makes the ball faster, and however fast it was, it did not
/// pass through anything in this tick. To be called after `roll`, once a tick.
/// Sets `world.touched` to the robot that touched it last; of two at once it is home's in even ticks, away's in odd
/// ones. Draws from the event push_noise. `crowd` is that of `world`.
void bounce_ball(const field::Field& field, const BallModel& ball, const ContactModel& contact, const Effects& effects,
                 const Crowd& crowd, World& world);

/// Moves the walking referee one tick on, at 1 m/s at most: it keeps 1.5 m from the ball. At first it stands on the
/// long axis of the field, on the side that the key draws from the event official.
void walk_official(const field::Field& field, World& world);

}  // namespace sim
