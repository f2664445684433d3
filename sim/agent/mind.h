// The memory of an agent between decisions.
#pragma once

#include <cstdint>

#include "sim/agent/choice.h"
#include "sim/math/tick.h"
#include "sim/math/vec2.h"

namespace sim::agent {

enum class Role : std::uint8_t { keeper, chaser, supporter, defender };

/// Mind.leaf of a robot that does not play: penalised, or not in the phase playing.
inline constexpr std::uint16_t kNoLeaf = 0xffff;

/// The memory. Plain data: it is part of the simulator's state.
struct Mind {
  Role role = Role::supporter;
  std::uint8_t slot = 8;         // its lane among those of its role, see sim/agent/roles.h: 8 is the middle
  std::uint16_t leaf = kNoLeaf;  // leaf of the tree that it plays
  Tick role_since = 0;
  Tick leaf_since = 0;
  Vec2 ball;                // [m, team_field] the ball by all reports
  Tick ball_seen = kNever;  // of the report behind it
  Tick search_since = kNever;
  float kick_direction = 0;                // [rad, team_field] wanted direction of the ball
  std::uint8_t kick = 0;                   // index of the kick it aligns for
  std::uint8_t aligned = 0;                // decisions in a row with the ball in its gate
  std::uint8_t settled = 0;                // [ticks] time of the last assignment of roles, lower 8 bits
  std::int8_t search_side = 1;             // +1 left, -1 right: side of the ball, and leg of the kick
  std::uint16_t time_to_ball_cs = 0xffff;  // [10 ms] own estimate, as it is sent to teammates
  bool holds = false;                      // stands at its place until it is far off
  Choice choice;                           // of a team that chooses between strategies
  std::uint16_t told = 0;                  // [ticks] time when it last made or heard that choice, lower 16 bits

  float time_to_ball() const { return 0.01f * static_cast<float>(time_to_ball_cs); }  // [s]
};

/// Returns the value of Mind.search_side for a point: +1 for y >= 0 (left), -1 otherwise.
constexpr std::int8_t left_or_right(float y) { return y < 0 ? std::int8_t{-1} : std::int8_t{1}; }

}  // namespace sim::agent
