// Scenes for the tests of the agent: beliefs of a robot, made by hand or at random.
#pragma once

#include <random>
#include <string_view>

#include "sim/agent/tree.h"
#include "sim/field/field.h"
#include "sim/motion/model.h"

namespace sim::agent {

/// The field of 2012 and the body of a match.
const Surroundings& surroundings();

/// Four players a side; player 2 stands in the middle, faces the goal and sees the ball 1 m ahead.
struct Scene {
  Scene();

  Settings settings;
  Game game;
  Beliefs beliefs;
  Mind mind;
  Tick now = 3000;

  View view() const { return {surroundings(), settings, game, beliefs, now, mind}; }
  motion::Command decide(const Behaviour& behaviour, Trace* trace = nullptr) {
    return behaviour.decide(surroundings(), game, beliefs, now, mind, trace);
  }

  /// Puts the ball in sight and at rest [m, robot].
  void see_ball(Vec2 in_robot);
  /// Adds a message of a teammate, by its number, `ago` [s].
  Mate& hear(int player, Vec2 position, float time_to_ball, Role role, float ago = 0);
  void see_opponent(int number, Vec2 position) { beliefs.opponents[number - 1] = {position, now}; }
};

/// Makes random beliefs in play, in a game of 1 to 7 players.
Scene random_scene(std::mt19937& random);

/// Parses a tree. The test fails if that is impossible.
Tree tree_of(std::string_view text);
/// Loads a shipped strategy.
Tree shipped(const char* name);
inline constexpr const char* kShipped[] = {"align_first", "all_kicks", "baseline", "idle", "kick_now", "passing"};

}  // namespace sim::agent
