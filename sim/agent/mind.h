// What an agent remembers from one decision to the next.
#pragma once

#include <cstdint>

#include "sim/agent/choice.h"
#include "sim/math/tick.h"
#include "sim/math/vec2.h"

namespace sim::agent {

enum class Role : std::uint8_t { keeper, chaser, supporter, defender };

/// Mind.leaf of a robot that does not play: penalised, or not in the phase playing.
inline constexpr std::uint16_t kNoLeaf = 0xffff;

/// Plain data: it is part of the simulator's state.
struct Mind {
  Role role = Role::supporter;
  std::uint8_t slot = 8;         // its lane among those of its role, see sim/agent/roles.h: 8 is the middle
  std::uint16_t leaf = kNoLeaf;  // of the tree: what it does now
  Tick role_since = 0;
  Tick leaf_since = 0;
  float time_to_ball = 1e6f;  // [s] its own estimate, told to teammates
  Vec2 ball;                  // [m, team_field] where it takes the ball to be, by all reports
  Tick ball_seen = kNever;    // of the report behind it
  Tick search_since = kNever;
  float kick_direction = 0;     // [rad, team_field] where the ball shall go
  std::uint8_t kick = 0;        // index of the kick it aligns for
  std::uint8_t aligned = 0;     // decisions in a row in which the ball lay right for it
  std::uint8_t settled = 0;     // [ticks] when it last looked who does what, its lower 8 bits
  std::int8_t search_side = 1;  // +1 left, -1 right: where the ball was last, the leg to kick with
  Choice choice;                // of a team that chooses between strategies
  std::uint16_t told = 0;       // [ticks] when it last made or heard that choice, its lower 16 bits
};

/// +1 for Mind.search_side: +1 for what is left, at y >= 0, -1 for what is right.
constexpr std::int8_t left_or_right(float y) { return y < 0 ? std::int8_t{-1} : std::int8_t{1}; }

}  // namespace sim::agent
