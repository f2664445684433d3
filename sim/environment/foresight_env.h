/* Games of simulated robot soccer for learners: thousands side by side, in C.
 *
 *   foresight_env* games = foresight_env_open(FORESIGHT_ENV_VERSION, "{\"games\": 1024, \"drill\": \"empty_goal\"}",
 *                                             problem, sizeof problem);
 *   foresight_env_arrays arrays = foresight_env_arrays_of(games);
 *   foresight_env_reset(games, seeds, NULL);
 *   for (;;) {
 *     choose(arrays.observations, arrays.actions);    // in place: nothing is copied
 *     foresight_env_step(games);
 *   }
 *
 * All arrays belong to the environment, lie at the same place until it is closed, and have rows by game, and in a game by
 * agent. The same library calls with the same options, seeds and actions give the same bytes on every machine.
 *
 * Functions that return an int return 0, or -1 after a failure; foresight_env_error then has one sentence, and nothing has
 * changed. One thread at a time may use an environment. Different threads may use different ones.
 */
#ifndef FORESIGHT_ENV_H
#define FORESIGHT_ENV_H

#include <stddef.h>
#include <stdint.h>

#ifdef __cplusplus
extern "C" {
#endif

/* The version of this interface. It changes when a program that was compiled before would fail. */
#define FORESIGHT_ENV_VERSION 1

typedef struct foresight_env foresight_env;

/* The sizes of the arrays. */
typedef struct {
  int32_t games;   /* side by side */
  int32_t agents;  /* of one game */
  int32_t columns; /* of an observation */
  int32_t width;   /* of an action */
} foresight_env_shape;

/* The arrays. `rows` is games * agents. */
typedef struct {
  const float* observations; /* rows x columns, each in [-1, 1]: of the robot's newest turn, or of the start */
  float* actions;            /* rows x width: the caller writes them before each step */
  const float* rewards;      /* rows */
  const uint8_t* terminated; /* rows: the episode has ended by its own rules */
  const uint8_t* truncated;  /* rows: its time is over */
  const uint8_t* active;     /* rows: the robot is on the field, in play, and obeys the next action */
  const uint8_t* succeeded;  /* games: the episode ended with the success of the drill */
  const uint64_t* seeds;     /* games: of the present episode */
} foresight_env_arrays;

/* Returns the version that the library implements. */
int32_t foresight_env_version(void);

/* Opens an environment. `version` is FORESIGHT_ENV_VERSION; `options` is a JSON object, described in
 * sim/environment/options.h. Returns NULL after a failure, and writes a sentence of at most `room` - 1 bytes to `problem`. */
foresight_env* foresight_env_open(int32_t version, const char* options, char* problem, size_t room);
/* NULL has no effect. */
void foresight_env_close(foresight_env* env);

foresight_env_shape foresight_env_shape_of(const foresight_env* env);
foresight_env_arrays foresight_env_arrays_of(foresight_env* env);

/* Returns a description in JSON: agents, columns with feature, unit and formula, and actions. It lives as long as the
 * environment. */
const char* foresight_env_about(const foresight_env* env);

/* Begins new episodes. `seeds` has one seed per game. `which` has one byte per game, and games with 0 stay as they are;
 * NULL resets all. */
int32_t foresight_env_reset(foresight_env* env, const uint64_t* seeds, const uint8_t* which);

/* Plays on by the actions in the array. With "restart": "next_step", a game that ended in the last step begins its next
 * episode instead, without an action and with reward 0. With "never" it stays at its end. */
int32_t foresight_env_step(foresight_env* env);

/* Checks each game: all numbers are finite, all enumerators and indices exist. For tests. */
int32_t foresight_env_check(foresight_env* env);

/* Returns a hash of the state of a game, or 0 for a number that no game has. */
uint64_t foresight_env_hash(const foresight_env* env, int32_t game);

/* Returns the sentence of the last failure, or an empty text. It lives until the next call. */
const char* foresight_env_error(const foresight_env* env);

#ifdef __cplusplus
}
#endif

#endif
