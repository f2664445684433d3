// A complete behaviour as a shared library: the starting point of your own. It plays about as well as `baseline`. The
// skills are in soccer.h; the decisions are here. charge.py is the same in Python.
//
//   cd sim/guest/examples
//   cc -std=c99 -O2 -ffp-contract=off -fPIC -shared -I .. -I . charge.c -lm -o charge.so
//   foresight-sim match --home ./charge.so
#include <foresight_behaviour.h>
#include <soccer.h>
#include <stdlib.h>
#include <string.h>

// The memory of a player. Plain data: it is saved byte by byte.
typedef struct {
  ForesightPlayer facts;
  SoccerMemory memory;
} Player;

static const float kTolerance = 0.26f;  // [rad] allowed error of a kick
static const float kAnyWay = 1.05f;     // [rad] where the direction matters little

static void forget(SoccerMemory* memory) {
  memory->role = FORESIGHT_SUPPORTER, memory->left_foot = 1, memory->searching = FORESIGHT_NEVER;
}

static void* create(const ForesightPlayer* facts) {
  Player* self = calloc(1, sizeof *self);
  if (self) self->facts = *facts, forget(&self->memory);
  return self;
}

static void destroy(void* self) { free(self); }

// The goalkeeper comes out and clears a near ball.
static void keep(const Sight* sight, SoccerMemory* memory, ForesightCommand* command) {
  const Point ball = sight->ball_in_team;
  const int near = size(minus(ball, sight->own_goal)) < 1.3f && sight->ball_distance < 1.4f && sight->ball_age < 30;
  if (!near) {
    guard_goal(sight, command);
    return;
  }
  const Point away = add(ball, minus(ball, sight->own_goal));
  kick_to(sight, memory, away, 0, kAnyWay, 5, command);
}

static void chase(const Sight* sight, SoccerMemory* memory, ForesightCommand* command) {
  const Point ball = sight->ball_in_team;
  const float to_goal = size(minus(sight->goal, ball));
  float slack;
  const Point target = opening(sight, &slack);
  if (sight->moment->set_play == FORESIGHT_KICK_OFF && sight->moment->own_kick) {
    kick_to(sight, memory, add(ball, point(1, 0)), 0, kAnyWay, 1, command);
  } else if (to_goal < 0.6f) {
    dribble_to(sight, target, 2 * kTolerance, command);
  } else {
    const int pressed = opponent_distance(sight, ball) < 0.6f || to_goal < 1.5f;
    kick_to(sight, memory, target, slack, kTolerance, pressed ? 1.8f : 5, command);
  }
}

static void decide(void* player, const ForesightMoment* moment, ForesightCommand* command) {
  Player* self = player;
  SoccerMemory* memory = &self->memory;
  if (moment->entered) forget(memory);
  const Sight sight = look(&self->facts, moment);
  const int32_t role = settle_role(&sight, memory, command);
  // outside play: the default
  if (moment->phase != FORESIGHT_PLAYING || moment->penalised) return;
  if (!sight.ball_known || (role == FORESIGHT_CHASER && sight.ball_age > 3 * 30)) {
    search_ball(&sight, memory, role == FORESIGHT_KEEPER, command);
    return;
  }
  memory->searching = FORESIGHT_NEVER;
  const int theirs = moment->set_play != FORESIGHT_NO_SET_PLAY && !moment->own_kick;
  if (role == FORESIGHT_KEEPER && theirs)
    guard_goal(&sight, command);
  else if (role == FORESIGHT_KEEPER)
    keep(&sight, memory, command);
  else if (role == FORESIGHT_CHASER && !theirs)
    chase(&sight, memory, command);
  else
    hold(&sight, role == FORESIGHT_SUPPORTER ? place_in_space(&sight) : place_between(&sight), command);
  keep_clear(&sight, command);
}

static size_t save(const void* self, void* bytes, size_t room) {
  if (room >= sizeof(Player)) memcpy(bytes, self, sizeof(Player));
  return sizeof(Player);
}

static int load(void* self, const void* bytes, size_t size) {
  if (size != sizeof(Player)) return 0;
  memcpy(self, bytes, size);
  return 1;
}

const ForesightBehaviour* foresight_behaviour(void) {
  static const ForesightBehaviour behaviour = {
      FORESIGHT_BEHAVIOUR_HEAD, "charge", create, destroy, decide, save, load,
  };
  return &behaviour;
}
