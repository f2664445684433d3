// Ground truth: the ball, the bodies, the time. Beliefs about it are in sim/agent/beliefs.h.
#pragma once

#include <cstdint>

#include "sim/field/rules.h"
#include "sim/math/random.h"
#include "sim/math/tick.h"
#include "sim/math/vec2.h"
#include "sim/world/ball.h"
#include "sim/world/body.h"

namespace sim {

inline constexpr int kMaxRobots = 2 * kMaxPlayers;

enum class Side : std::uint8_t { home, away };
constexpr Side other(Side side) { return side == Side::home ? Side::away : Side::home; }

constexpr Side side_of(int robot) { return robot < kMaxPlayers ? Side::home : Side::away; }
/// Returns the player's number in its team, 1..7.
constexpr int player_of(int robot) { return (robot < kMaxPlayers ? robot : robot - kMaxPlayers) + 1; }
constexpr int robot_of(Side side, int player) { return (side == Side::home ? 0 : kMaxPlayers) + player - 1; }

/// The walking referee, if Effects::official is on. Frame: field.
struct Official {
  Vec2 position{1e6f, 1e6f};  // [m] far away until `walk_official` places it
  Vec2 velocity;              // [m/s]
};

/// Reports whether the walking referee has been placed.
constexpr bool is_there(const Official& official) { return official.position.x < 1e5f; }

/// All ground truth of a game.
struct World {
  RandomKey key;
  Tick tick = 0;
  std::int32_t players = 0;  // of one side
  float home_attacks = 1;    // direction in which the home side attacks now: +1 towards +x of `field`, -1 towards -x
  std::uint8_t touched = kNobody;  // robot that touched the ball in this tick, kicks included; kNobody: none
  std::uint8_t kicked = kNobody;   // robot whose foot met the ball in this tick
  std::uint8_t whiffed = kNobody;  // robot whose foot missed it in this tick
  bool crowded = true;             // bodies may touch each other or a thing, even when nobody moves
  Ball ball;
  Official official;
  Body bodies[kMaxRobots];  // [0, players) are home 1.., [kMaxPlayers, kMaxPlayers + players) away 1..
};

/// Calls see(robot) with the index of each robot of this game, on the field or removed: home 1.., then away 1...
template <class See>
void for_each_robot(int players, See&& see) {
  for (int robot = 0; robot < players; ++robot) see(robot);
  for (int robot = kMaxPlayers; robot < kMaxPlayers + players; ++robot) see(robot);
}

/// Reports whether `robot` is recorded before `another` when both do the same thing in the same tick. The lower player
/// number comes first. Of equal numbers, the side that attacks +x comes first in even ticks, the other side in odd
/// ones. So neither side has an advantage.
constexpr bool is_named_before(const World& world, int robot, int another) {
  const auto attacks_right = [&](int one) { return (side_of(one) == Side::home) == (world.home_attacks > 0); };
  if (player_of(robot) != player_of(another)) return player_of(robot) < player_of(another);
  return attacks_right(robot) == (world.tick % 2 == 0) && robot != another;
}

/// Returns the direction in which a side attacks now, +1 or -1 along x. A point in its `team_field` times this is the
/// point in `field`, and vice versa.
constexpr float attack_sign(const World& world, Side side) {
  return side == Side::home ? world.home_attacks : -world.home_attacks;
}

}  // namespace sim
