// Skills of whoever has the ball, or nearly.
#pragma once

#include <cstdint>

#include "sim/agent/view.h"
#include "sim/motion/command.h"

namespace sim::agent {

/// Where the ball shall go.
enum class Aim : std::uint8_t {
  goal,     // the middle of the opponents' goal
  opening,  // the middle of the widest gap in it; the wider it is, the less exactly
  ahead,    // straight towards the opponents' goal line
  away,     // from the own goal
  mate,     // the free teammate nearest to the goal, ahead of it; without one, ahead
};
constexpr Aim as_aim(float argument) { return static_cast<Aim>(static_cast<int>(argument)); }

struct WalkToBall {
  Aim aim;
  float tolerance;  // [rad]
  float distance;   // [m]
  float gain;
};
/// Goes to `distance` behind the ball as seen from the aim, round the ball without touching it.
motion::Command walk_to_ball(const View& view, Mind& mind, const WalkToBall& with);

struct Align {
  Aim aim;
  float tolerance;  // [rad]
  float range;      // [m]
};
/// Goes to where a kick sends the ball to the aim.
motion::Command align(const View& view, Mind& mind, const Align& with);

struct Kick {
  Aim aim;
  float tolerance;  // [rad]
  float range;      // [m]
  float care;       // of the gate
  float frames;     // [decisions]
};
/// Aligns, choosing the leg the ball is nearer to, and kicks once the ball lies in the gate and the robot faces the aim.
/// The way behind the ball is no longer than the tolerance asks for.
motion::Command kick(const View& view, Mind& mind, const Kick& with);

struct Dribble {
  Aim aim;
  float tolerance;  // [rad]
  float gain;
};
/// Behind the ball, and on through it.
motion::Command dribble(const View& view, Mind& mind, const Dribble& with);

struct Pass {
  float tolerance;  // [rad]
  float lead;       // [m]
  float care;
  float frames;
};
motion::Command pass(const View& view, Mind& mind, const Pass& with);

}  // namespace sim::agent
