// The C interface of a team's own behaviour as a shared library: foresight-sim match --home ./my_behaviour.so. C99
// without dependencies, also for C++. Complete example: sim/guest/examples/charge.c.
//
//   cc -std=c99 -O2 -ffp-contract=off -fPIC -shared -I sim/guest my_behaviour.c -o my_behaviour.so
//
// The library exports one function, foresight_behaviour(). It returns the functions that make a player, decide, and
// optionally save and load its memory. Each robot of each game has its own player. Games run in several processes and
// threads at once. One player is used by one thread at a time; data outside of players must not change. A game is
// reproducible if decisions depend only on the player's input since it was made. Use no clock, and only random numbers
// that start from `seed`.
//
// Frames: `robot` is on the ground between the feet, +x forward, +y left; `team` has its origin at the centre of the
// field, +x towards the opponents' goal, +y left of it. Metres, seconds, radians, m/s. Ticks are 1/30 s of game time,
// counted from its start; FORESIGHT_NEVER is the time of an event that never happened. A robot decides in every tick
// that could matter: near the ball in every other tick, far from it 2 to 4 times a second (--every-tick: always).
#ifndef FORESIGHT_BEHAVIOUR_H
#define FORESIGHT_BEHAVIOUR_H

#include <stddef.h>
#include <stdint.h>

#ifdef __cplusplus
extern "C" {
#endif

#define FORESIGHT_BEHAVIOUR_VERSION 1

#define FORESIGHT_NEVER 0xffffffffu
#define FORESIGHT_MAX_PLAYERS 7
#define FORESIGHT_MAX_KICKS 8

// a kick with the left foot; the kick with the right foot is its mirror image
typedef struct {
  char name[16];
  float ball_x, ball_y;  // [m, robot] where the ball must lie
  float gate_x, gate_y;  // [m] half size of the region in which the kick is equally good
  float delay;           // [s] from the command to the foot touching the ball
  float duration;        // [s] from the command to being able to walk again
  float range;           // [m] distance that the ball rolls from there
  float direction;       // [rad, robot] direction of the ball
} ForesightKick;

// the data that do not change during a game
typedef struct {
  uint64_t seed;        // of the player's own random numbers; equal for the same game, side and player
  int32_t player;       // 1 .. players; 1 keeps the goal
  int32_t players;      // a side
  float field_length;   // [m] between the goal lines
  float field_width;    // [m] between the touch lines
  float goal_width;     // [m] between the posts
  float walk_forward;   // [m/s] greatest speeds
  float walk_backward;  // [m/s]
  float walk_sideward;  // [m/s]
  float walk_turn;      // [rad/s]
  int32_t kick_count;
  ForesightKick kicks[FORESIGHT_MAX_KICKS];
} ForesightPlayer;

enum {  // ForesightMoment.phase
  FORESIGHT_INITIAL,
  FORESIGHT_READY,
  FORESIGHT_SET,
  FORESIGHT_PLAYING,
  FORESIGHT_FINISHED
};

enum {  // ForesightMoment.set_play
  FORESIGHT_NO_SET_PLAY,
  FORESIGHT_KICK_OFF,
  FORESIGHT_KICK_IN,
  FORESIGHT_GOAL_KICK,
  FORESIGHT_CORNER_KICK
};

enum { FORESIGHT_KEEPER, FORESIGHT_CHASER, FORESIGHT_SUPPORTER, FORESIGHT_DEFENDER };  // roles, as sent to teammates

// the last message of a teammate
typedef struct {
  uint32_t sent;         // [tick] time of the message; FORESIGHT_NEVER: none yet, the other fields are invalid
  float x, y, heading;   // [team]
  float ball_x, ball_y;  // [m, team] the ball as it believed
  uint32_t ball_age;     // [ticks] age of its sight of the ball at that time; FORESIGHT_NEVER: never seen
  float time_to_ball;    // [s] its own estimate
  int32_t role;
  int32_t active;  // not penalised at that time
} ForesightMate;

// the place where an opponent was last seen
typedef struct {
  uint32_t seen;  // [tick] FORESIGHT_NEVER: not yet, the other fields are invalid
  float x, y;     // [m, team]
} ForesightOpponent;

// the beliefs of a robot, and the GameController's state
typedef struct {
  uint32_t now;     // [tick]
  int32_t entered;  // it has just entered the field (start, after a penalty, half time): its memory starts anew
  int32_t phase;
  int32_t set_play;
  int32_t own_kick;  // kick-off or set play is ours
  int32_t penalised;
  int32_t half;  // 1 ..
  int32_t own_score, opponent_score;
  float remaining;    // [s] of the half
  float since_phase;  // [s] since phase or set play last changed

  uint32_t ball_seen;       // [tick] last image with the ball; FORESIGHT_NEVER: none
  int32_t ball_visible;     // the newest image shows it
  float ball_x, ball_y;     // [m, robot]
  float ball_vx, ball_vy;   // [m/s, robot's axes] over ground
  float ball_deviation;     // [m] standard deviation along each axis
  float x, y, heading;      // [team] own pose
  float deviation;          // [m] standard deviation of the own position along each axis
  float deviation_heading;  // [rad]

  ForesightMate mates[FORESIGHT_MAX_PLAYERS];          // by number - 1; the own entry is never heard
  ForesightOpponent opponents[FORESIGHT_MAX_PLAYERS];  // by number - 1
} ForesightMoment;

enum {              // ForesightCommand.body
  FORESIGHT_USUAL,  // as trees do outside play: stand, and in the phase ready walk to the own place
  FORESIGHT_STAND,
  FORESIGHT_WALK_SPEED,  // x, y [m/s], turn [rad/s]
  FORESIGHT_WALK_TO,     // x, y [m, robot], turn [rad]: the heading on arrival; gain: share of the greatest speed
  FORESIGHT_KICK,        // kick, kick_left; gain: share of the kick's range
  FORESIGHT_SQUAT        // to block a ball
};

enum {                    // ForesightCommand.head
  FORESIGHT_LOOK_USUAL,   // follows the ball and looks for marks now and then
  FORESIGHT_LOOK_ANGLES,  // look: yaw [rad, > 0 left], pitch [rad, > 0 down]
  FORESIGHT_LOOK_TO       // look: x, y, z [m, robot]
};

// A command holds until the next. The defaults are FORESIGHT_USUAL, FORESIGHT_LOOK_USUAL, gain 1, and the role and time
// of the last message to the teammates.
typedef struct {
  int32_t body;
  int32_t head;
  float x, y, turn, gain;
  int32_t kick;       // index of ForesightPlayer.kicks
  int32_t kick_left;  // with the left foot
  float look[3];
  int32_t role;  // role in messages to teammates; it sets the rate of decisions: a chaser at least 3 times a second
  float time_to_ball;  // [s]
} ForesightCommand;

typedef struct {
  uint32_t version;       // FORESIGHT_BEHAVIOUR_VERSION
  uint32_t player_bytes;  // sizeof(ForesightPlayer), and so on: a stale library is refused
  uint32_t moment_bytes;
  uint32_t command_bytes;
  const char* name;

  // Makes a player for a new game. NULL ends the run.
  void* (*create)(const ForesightPlayer* player);
  void (*destroy)(void* self);
  void (*decide)(void* self, const ForesightMoment* moment, ForesightCommand* command);

  // Both or neither (NULL). save returns the size of the memory [bytes], and writes it if `room` is enough. load
  // restores it in a player made for the same robot, and returns 0 for invalid bytes. With both a game can be set back
  // to an earlier moment; without them it is played again from its seed.
  size_t (*save)(const void* self, void* bytes, size_t room);
  int (*load)(void* self, const void* bytes, size_t size);
} ForesightBehaviour;

#define FORESIGHT_BEHAVIOUR_HEAD \
  FORESIGHT_BEHAVIOUR_VERSION, sizeof(ForesightPlayer), sizeof(ForesightMoment), sizeof(ForesightCommand)

// The exported function. The data behind its result must not change.
const ForesightBehaviour* foresight_behaviour(void);

#ifdef __cplusplus
}
#endif

#endif
