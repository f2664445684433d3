// A behaviour of a team's own as a shared library: foresight-sim match --home ./my_behaviour.so. C99 without
// dependencies; also for C++. sim/guest/examples/charge.c is a whole one.
//
//   cc -std=c99 -O2 -ffp-contract=off -fPIC -shared -I sim/guest my_behaviour.c -o my_behaviour.so
//
// The library exports one function, foresight_behaviour(). What it returns says how to make a player, how it decides,
// and, if it can, how its memory is saved and loaded. Each robot of each game has a player of its own. Games are played in
// several processes and threads at once: one player is used by one thread at a time, and what is kept outside of players
// must not change. A game is the same every time if decisions are functions of what the player was told since it was made;
// use no clock and no random numbers but such that begin with `seed`.
//
// Frames: `robot` is on the ground between the feet, +x forward, +y left; `team` has its origin at the centre of the
// field, +x towards the opponents' goal, +y left of it. Metres, seconds, radians, m/s. Ticks are 1/30 s of game time,
// counted from its start; FORESIGHT_NEVER is the time of what never happened. A robot decides in every tick in which it
// could matter, next to the ball in every other one, far from it 2 to 4 times a second (--every-tick: always).
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

// one thing of a kick: for the left foot; the right foot's is its mirror image
typedef struct {
  char name[16];
  float ball_x, ball_y;  // [m, robot] where the ball must lie
  float gate_x, gate_y;  // [m] half size of the region in which the kick is as good as there
  float delay;           // [s] from the command to the foot touching the ball
  float duration;        // [s] from the command to being able to walk again
  float range;           // [m] how far the ball rolls from there
  float direction;       // [rad, robot] where the ball goes
} ForesightKick;

// what stays the same during a game
typedef struct {
  uint64_t seed;        // of chance of the player's own; the same for the same game, side and player
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

enum { FORESIGHT_KEEPER, FORESIGHT_CHASER, FORESIGHT_SUPPORTER, FORESIGHT_DEFENDER };  // roles, as teammates are told

// what a teammate last told
typedef struct {
  uint32_t sent;         // [tick] when it told; FORESIGHT_NEVER: never heard, the rest means nothing
  float x, y, heading;   // [team]
  float ball_x, ball_y;  // [m, team] where it believed the ball
  uint32_t ball_age;     // [ticks] since it had seen the ball when it told; FORESIGHT_NEVER: never
  float time_to_ball;    // [s] that it said it needs
  int32_t role;
  int32_t active;  // was not penalised when it told
} ForesightMate;

// where an opponent was last seen
typedef struct {
  uint32_t seen;  // [tick] FORESIGHT_NEVER: not yet, the rest means nothing
  float x, y;     // [m, team]
} ForesightOpponent;

// what a robot believes, and what the GameController tells it
typedef struct {
  uint32_t now;     // [tick]
  int32_t entered;  // it comes onto the field just now, at the start, after a penalty or half time: it begins anew
  int32_t phase;
  int32_t set_play;
  int32_t own_kick;  // kick-off or set play is ours
  int32_t penalised;
  int32_t half;  // 1 ..
  int32_t own_score, opponent_score;
  float remaining;    // [s] of the half
  float since_phase;  // [s] since phase or set play last changed

  uint32_t ball_seen;       // [tick] when an image last showed the ball; FORESIGHT_NEVER: not once
  int32_t ball_visible;     // the newest image shows it
  float ball_x, ball_y;     // [m, robot]
  float ball_vx, ball_vy;   // [m/s, robot's axes] over ground
  float ball_deviation;     // [m] standard deviation along each axis
  float x, y, heading;      // [team] oneself
  float deviation;          // [m] standard deviation of one's place along each axis
  float deviation_heading;  // [rad]

  ForesightMate mates[FORESIGHT_MAX_PLAYERS];          // by number less 1; one's own entry is never heard
  ForesightOpponent opponents[FORESIGHT_MAX_PLAYERS];  // by number less 1
} ForesightMoment;

enum {              // ForesightCommand.body
  FORESIGHT_USUAL,  // what every tree does outside play: stand, and in the phase ready walk to one's place
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

// Holds until the next. What is handed in is FORESIGHT_USUAL, FORESIGHT_LOOK_USUAL, gain 1, and what the teammates were
// told last.
typedef struct {
  int32_t body;
  int32_t head;
  float x, y, turn, gain;
  int32_t kick;       // index of ForesightPlayer.kicks
  int32_t kick_left;  // with the left foot
  float look[3];
  int32_t role;        // what the teammates are told, and how often a robot decides: a chaser at least 3 times a second
  float time_to_ball;  // [s]
} ForesightCommand;

typedef struct {
  uint32_t version;       // FORESIGHT_BEHAVIOUR_VERSION
  uint32_t player_bytes;  // sizeof(ForesightPlayer), and so on: told, so that a stale library is refused
  uint32_t moment_bytes;
  uint32_t command_bytes;
  const char* name;

  // A player of a game that begins, or NULL, which ends the run.
  void* (*create)(const ForesightPlayer* player);
  void (*destroy)(void* self);
  void (*decide)(void* self, const ForesightMoment* moment, ForesightCommand* command);

  // Both or neither (NULL). save returns how many bytes the memory takes, and writes them if `room` is enough; load puts
  // it into a player that was made for the same robot, and returns 0 if these bytes make no sense. A game can then be taken
  // back to a moment of it; without them it is played again from its seed up to there.
  size_t (*save)(const void* self, void* bytes, size_t room);
  int (*load)(void* self, const void* bytes, size_t size);
} ForesightBehaviour;

#define FORESIGHT_BEHAVIOUR_HEAD \
  FORESIGHT_BEHAVIOUR_VERSION, sizeof(ForesightPlayer), sizeof(ForesightMoment), sizeof(ForesightCommand)

// What the library exports; what it points to stays as it is.
const ForesightBehaviour* foresight_behaviour(void);

#ifdef __cplusplus
}
#endif

#endif
