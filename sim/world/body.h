// A robot's body, as it truly is.
#pragma once

#include <cstdint>

#include "sim/math/tick.h"
#include "sim/math/vec2.h"

namespace sim {

/// Frame: field; its velocity in its own.
struct Body {
  enum class Doing : std::uint8_t {
    standing,
    starting,
    walking,
    stopping,
    kicking,
    crouching,  // on its way down to block the ball
    squatting,  // down, wider than it stands
    fallen,
    getting_up,
    removed
  };

  Vec2 position;         // [m]
  float heading = 0;     // [rad] (-π, π]
  Vec2 facing{1, 0};     // the unit vector at `heading`
  Vec2 velocity;         // [m/s, robot] as it walks now
  float turn_rate = 0;   // [rad/s]
  float head_yaw = 0;    // [rad] > 0 left
  float head_pitch = 0;  // [rad] > 0 down
  Vec2 look{1, 0};       // [robot] the unit vector at `head_yaw`
  Doing doing = Doing::standing;
  std::uint8_t kick = 0;      // kicking: index into the kick table
  bool kick_left = false;     // kicking: with the left foot
  bool kick_done = false;     // kicking: the foot has passed where the ball should be
  float kick_gain = 1;        // kicking: share of the range
  Tick since = 0;             // when it began to do this
  Vec2 step_velocity;         // [m/s, robot] where the present step leads to
  float step_turn_rate = 0;   // [rad/s] likewise
  float walked = 0;           // [m] in this game
  std::uint8_t touching = 0;  // ticks in a row pressed against another robot, at most 255
  std::uint8_t pushing = 0;   // [1/5 s] it has been running into one
  std::uint8_t glide = 1;     // [ticks] that it moves at once (sim/match/pace.h)
  std::uint8_t moved = 0;     // up to which tick it has: the lower 8 bits
};

/// It is on the ground: fallen, or on its way up.
inline bool lies(const Body& body) {
  return body.doing == Body::Doing::fallen || body.doing == Body::Doing::getting_up;
}

}  // namespace sim
