// A robot's body: ground truth.
#pragma once

#include <cstdint>

#include "sim/math/tick.h"
#include "sim/math/vec2.h"

namespace sim {

/// The unit of Body::pushing: contacts are counted five times a second.
inline constexpr Tick kPushingUnit = 6;  // [ticks]

/// The side of a body that is down; a number beyond these counts as a side.
enum class Lying : std::uint8_t { on_back, on_front, on_left, on_right };

/// The true state of a body. Frame: field, but velocities are in the robot's own frame.
struct Body {
  enum class Doing : std::uint8_t {
    standing,
    starting,
    walking,
    stopping,
    kicking,
    crouching,  // on the way down to block the ball
    squatting,  // down, wider than when it stands
    fallen,
    getting_up,
    removed
  };

  Vec2 position;         // [m]
  float heading = 0;     // [rad] (-π, π]
  Vec2 facing{1, 0};     // the unit vector at `heading`
  Vec2 velocity;         // [m/s, robot] current walking velocity
  float turn_rate = 0;   // [rad/s]
  float head_yaw = 0;    // [rad] > 0 left
  float head_pitch = 0;  // [rad] > 0 down
  Vec2 look{1, 0};       // [robot] the unit vector at `head_yaw`
  Doing doing = Doing::standing;
  std::uint8_t kind = 0;   // kicking: index into the kick table; on the ground: the Lying, if a table of falls knows it
  bool kick_left = false;  // kicking: with the left foot
  bool kick_done = false;  // kicking: the foot has passed the place of the ball
  float kick_gain = 1;     // kicking: share of the range
  Tick since = 0;          // start of `doing`
  Vec2 step_velocity;      // [m/s, robot] target of the current walking step
  float step_turn_rate = 0;   // [rad/s] likewise
  float walked = 0;           // [m] in this game
  std::uint8_t touching = 0;  // [ticks] in contact with another robot without a break, at most 255
  std::uint8_t pushing = 0;   // [kPushingUnit] running into another robot without a break
  std::uint8_t glide = 1;     // [ticks] moved in one piece (sim/match/pace.h)
  std::uint8_t moved = 0;     // tick up to which the body has moved, its lower 8 bits
};

/// Reports whether the body is on the field, and not removed from it.
inline bool on_field(const Body& body) { return body.doing != Body::Doing::removed; }

/// Reports whether the body is on the ground: fallen, or getting up.
inline bool lies(const Body& body) {
  return body.doing == Body::Doing::fallen || body.doing == Body::Doing::getting_up;
}

}  // namespace sim
