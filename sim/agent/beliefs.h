// The beliefs of a robot: everything that an agent may know.
//
// The simulator computes them; on the robot they come from memory objects. Frames: `robot` is on the ground
// between the feet, +x forward, +y left; `team_field` has its origin at the centre, +x towards the opponents' goal.
#pragma once

#include <cstdint>

#include "sim/agent/choice.h"
#include "sim/field/rules.h"
#include "sim/math/tick.h"
#include "sim/math/vec2.h"

namespace sim::agent {

inline constexpr int kMaxMates = kMaxPlayers - 1;

/// The ball as the robot's own eyes saw it.
struct Ball {
  Vec2 position;                // [m, robot]
  Vec2 velocity;                // [m/s, robot's axes] over ground
  float variance = 0;           // [m²] of the position along each axis
  float covariance = 0;         // [m²/s] between position and velocity along each axis
  float velocity_variance = 0;  // [m²/s²]
  float heat = 0;               // [0..1] how likely an opponent is to kick it soon
  Tick seen = kNever;           // time of the last image that showed it; kNever: none
  bool visible = false;         // the newest image shows it
  std::uint8_t frames = 0;      // images in a row that showed it (visible) or did not, at most 255
};

/// The pose that the robot believes it has.
struct Pose {
  Pose2 pose;                   // [team_field]
  float deviation = 0;          // [m] standard deviation of the position along each axis
  float deviation_heading = 0;  // [rad]
};

/// The last message of a teammate.
struct Mate {
  Pose2 pose;                         // [team_field]
  Vec2 ball;                          // [m, team_field] the ball as it believed
  Tick sent = kNever;                 // time of the message; kNever: none yet
  std::uint16_t ball_age = 0xffff;    // [ticks] age of its sight of the ball at that time; 0xffff: never seen
  std::uint16_t time_to_ball_cs = 0;  // [10 ms] its own estimate, at most 0xffff
  std::uint8_t role = 0;              // agent::Role
  bool active = false;                // not penalised at that time
  Choice choice;                      // the choice that it followed

  float time_to_ball() const { return 0.01f * static_cast<float>(time_to_ball_cs); }  // [s]
};
/// Converts a time [s] >= 0 to the unit of a message [10 ms].
constexpr std::uint16_t centiseconds(float seconds) {
  return seconds < 655 ? static_cast<std::uint16_t>(0.5f * (200 * seconds + 1)) : std::uint16_t{0xffff};
}

/// Returns the number [1..7] of the teammate in beliefs.mates[index] of `player`.
constexpr int player_of_mate(int player, int index) { return index + 1 < player ? index + 1 : index + 2; }
/// Returns the index of teammate `mate` [1..7, not `player`] in beliefs.mates of `player`.
constexpr int index_of_mate(int player, int mate) { return mate < player ? mate - 1 : mate - 2; }

/// The place where an opponent was last seen.
struct Opponent {
  Vec2 position;       // [m, team_field]
  Tick seen = kNever;  // kNever: not yet
};

/// One robot's beliefs. `mates` are the teammates by number without the robot itself:
/// for player 3, mates[2] is player 4.
struct Beliefs {
  Ball ball;
  Pose pose;
  Mate mates[kMaxMates];
  Opponent opponents[kMaxPlayers];  // by number; real robots do not recognise each opponent
};

/// The GameController's state as a robot hears it, and the robot's own number.
struct Game {
  enum class Phase : std::uint8_t { initial, ready, set, playing, finished };
  enum class SetPlay : std::uint8_t { none, kick_off, kick_in, goal_kick, corner_kick };

  Phase phase = Phase::initial;
  SetPlay set_play = SetPlay::none;
  bool own_kick = false;  // kick-off or set play is ours
  bool penalised = false;
  std::uint8_t player = 1;   // [1..7]; 1 keeps the goal
  std::uint8_t players = 4;  // a side
  std::uint8_t half = 1;
  std::uint8_t own_score = 0;
  std::uint8_t opponent_score = 0;
  float remaining = 0;    // [s] of the half
  float since_phase = 0;  // [s] since phase or set play last changed
};

/// The words of the set plays in all texts, by enumerator. A null pointer ends them.
inline constexpr const char* kPhaseWords[] = {"initial", "ready", "set", "playing", "finished"};
inline constexpr const char* kSetPlayWords[] = {"none", "kick_off", "kick_in", "goal_kick", "corner_kick", nullptr};
/// Number of set plays, with `none`.
inline constexpr int kSetPlays = static_cast<int>(Game::SetPlay::corner_kick) + 1;
static_assert(sizeof(kSetPlayWords) / sizeof(kSetPlayWords[0]) == kSetPlays + 1);

}  // namespace sim::agent
