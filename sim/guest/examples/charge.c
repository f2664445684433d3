// A complete behaviour as a shared library. The robot nearest to the ball goes behind it and kicks it towards the goal,
// one waits behind, the goalkeeper stays between ball and goal. charge.py is the same in Python.
//
//   cc -std=c99 -O2 -ffp-contract=off -fPIC -shared -I sim/guest sim/guest/examples/charge.c -lm -o charge.so
//   foresight-sim match --home ./charge.so
#include <foresight_behaviour.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

// The memory of a player. Plain data: it is saved byte by byte.
typedef struct {
  ForesightPlayer facts;
  uint32_t lost_since;  // [tick] time when it lost the ball; FORESIGHT_NEVER: not lost
} Player;

static const uint32_t kForgotten = 5 * 30;  // [ticks] a ball unseen for longer is lost
static const float kSearchTurn = 0.8f;      // [rad/s]
static const float kBehind = 0.3f;          // [m] behind the ball, where it turns to the goal
static const float kStraight = 0.35f;       // [rad] allowed error of a kick
static const float kAhead = 0.5f;           // [m] lead of a teammate that gets the ball

static void* create(const ForesightPlayer* facts) {
  Player* self = calloc(1, sizeof *self);
  if (self) self->facts = *facts, self->lost_since = FORESIGHT_NEVER;
  return self;
}

static void destroy(void* self) { free(self); }

// Returns a point of the field in the frame of the robot.
static void to_robot(const ForesightMoment* moment, float x, float y, float* out_x, float* out_y) {
  const float c = cosf(moment->heading), s = sinf(moment->heading);
  const float dx = x - moment->x, dy = y - moment->y;
  *out_x = c * dx + s * dy, *out_y = c * dy - s * dx;
}

static void walk_to(ForesightCommand* command, float x, float y, float turn) {
  command->body = FORESIGHT_WALK_TO;
  command->x = x, command->y = y, command->turn = turn;
}

// Returns whether another field player is nearer to the ball.
static int is_left_to_a_mate(const Player* self, const ForesightMoment* moment, float distance) {
  for (int i = 1; i < self->facts.players; ++i) {
    const ForesightMate* mate = &moment->mates[i];
    if (mate->sent == FORESIGHT_NEVER || !mate->active || moment->now - mate->sent > 300) continue;
    if (mate->time_to_ball * self->facts.walk_forward < distance - kAhead) return 1;
  }
  return 0;
}

static void search(Player* self, const ForesightMoment* moment, ForesightCommand* command) {
  if (self->lost_since == FORESIGHT_NEVER) self->lost_since = moment->now;
  command->body = FORESIGHT_WALK_SPEED;
  // the other way round after a whole turn
  const uint32_t turns = (moment->now - self->lost_since) / 240;
  command->turn = turns % 2 == 0 ? kSearchTurn : -kSearchTurn;
}

static void attack(const Player* self, const ForesightMoment* moment, float distance, ForesightCommand* command) {
  float goal_x, goal_y;
  to_robot(moment, self->facts.field_length / 2, 0, &goal_x, &goal_y);
  const float way = atan2f(goal_y - moment->ball_y, goal_x - moment->ball_x);  // of the ball, seen from the robot
  const ForesightKick* kick = &self->facts.kicks[0];

  if (distance > 2 * kBehind) {
    // straight to a place behind the ball
    walk_to(command, moment->ball_x - kBehind * cosf(way), moment->ball_y - kBehind * sinf(way), way);
    return;
  }
  const int left = moment->ball_y > 0;
  const float foot = left ? kick->ball_y : -kick->ball_y;
  const int in_gate =
      fabsf(moment->ball_x - kick->ball_x) < kick->gate_x && fabsf(moment->ball_y - foot) < kick->gate_y;
  if (in_gate && fabsf(way) < kStraight) {
    command->body = FORESIGHT_KICK;
    command->kick = 0, command->kick_left = left;
    return;
  }
  // to where the ball lies before the foot, facing the goal
  const float c = cosf(way), s = sinf(way);
  walk_to(command, moment->ball_x - c * kick->ball_x + s * foot, moment->ball_y - s * kick->ball_x - c * foot, way);
}

static void decide(void* memory, const ForesightMoment* moment, ForesightCommand* command) {
  Player* self = memory;
  if (moment->entered) self->lost_since = FORESIGHT_NEVER;
  const int keeper = self->facts.player == 1;
  command->role = keeper ? FORESIGHT_KEEPER : FORESIGHT_SUPPORTER;
  command->time_to_ball = 1e6f;
  // outside play and at the opponents' kick: the default
  if (moment->phase != FORESIGHT_PLAYING || moment->penalised) return;
  if (moment->ball_seen == FORESIGHT_NEVER || moment->now - moment->ball_seen > kForgotten) {
    search(self, moment, command);
    return;
  }
  self->lost_since = FORESIGHT_NEVER;
  const float distance = hypotf(moment->ball_x, moment->ball_y);
  command->time_to_ball = distance / self->facts.walk_forward;
  const float bearing = atan2f(moment->ball_y, moment->ball_x);
  if (moment->set_play != FORESIGHT_NO_SET_PLAY && !moment->own_kick) return;

  if (keeper) {
    float x, y;
    to_robot(moment, -self->facts.field_length / 2 + 0.4f, 0, &x, &y);
    walk_to(command, x, y, bearing);
  } else if (is_left_to_a_mate(self, moment, distance)) {
    walk_to(command, moment->ball_x - 1.5f * cosf(moment->heading), moment->ball_y + 1.5f * sinf(moment->heading),
            bearing);
  } else {
    command->role = FORESIGHT_CHASER;
    attack(self, moment, distance, command);
  }
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
