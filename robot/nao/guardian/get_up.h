// Getting up from the ground.
#pragma once

#include <array>

#include "robot/nao/guardian/key_frames.h"

namespace robot::nao {

/// The side of a robot that is down.
enum class Lying { on_back, on_front, on_left, on_right };

/// Returns the side that is down, from roll and pitch of the torso [rad] of a robot that lies.
Lying lying(const std::array<float, 2>& angles);

/// Returns the motion of a robot that lies there. From the back it ends in the stand. From elsewhere it ends on the back:
/// such a robot rolls over first.
///
/// The way up is that of HULKs (github.com/HULKs/hulk, etc/motions/stand_up_back.json): sit up with the arms behind the body,
/// pull one foot under it, push with the other leg. From the seat on, the search began at their angles. Rolling over and
/// sitting up are our own. All were searched on simulated robots (tests/walk/tune_get_up.cpp). No real robot has played them.
KeyFrames get_up(Lying lying);

}  // namespace robot::nao
