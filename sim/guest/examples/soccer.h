// A helper for behaviours in C: avoidance, roles, places in space and kick gates. soccer.py is the same in Python. Copy
// it beside your behaviour and change what you like. charge.c shows its use.
//
// Frames and units are those of foresight_behaviour.h. Each function that moves the robot writes the command.
#ifndef FORESIGHT_SOCCER_H
#define FORESIGHT_SOCCER_H

#include <foresight_behaviour.h>
#include <math.h>

static const float kPi = 3.14159265f;

// beliefs
static const uint32_t kOwnEyes = 2 * 30;         // [ticks] the own sight of the ball beats reports for this time
static const uint32_t kBallMemory = 12 * 30;     // [ticks] a ball that nobody saw for longer is unknown
static const uint32_t kMateMemory = 12 * 30;     // [ticks] a teammate silent for longer has no role
static const uint32_t kOpponentMemory = 3 * 30;  // [ticks]
static const float kDeceleration = 0.3f;         // [m/s²] of a rolling ball
// walking
static const float kAvoidRadius = 0.45f;  // [m] from a robot in the way
static const float kLookAhead = 1.5f;     // [m] robots farther away are not in the way yet
static const float kThere = 0.12f;        // [m] near enough to a place
static const float kFarthest = 20;        // [m]
static const float kFaces = 0.35f;        // [rad] near enough to a heading
static const float kKeepClear = 0.9f;     // [m] from the ball of the opponents' kick
// roles
static const float kLead = 1;           // [s] that another robot needs to take over the ball
static const float kOrderKeep = 0.6f;   // [m] farther back that another robot needs to become the defender
static const float kDefenders = 0.34f;  // share of defenders among those without ball and goal
// kicks
static const float kGateShare = 0.7f;   // of the tolerance that the approach uses; noise needs the rest
static const float kStillBall = 0.35f;  // [m/s] a faster ball is not kicked
static const uint32_t kFreshBall = 21;  // [ticks] a ball seen longer ago is not kicked

typedef struct {
  float x, y;
} Point;

// The memory of the helper, one per player. Plain data, so that it can be saved byte by byte.
typedef struct {
  int32_t role;
  int32_t left_foot;   // kicks with the left foot
  uint32_t searching;  // [tick] begin of the search for the ball; FORESIGHT_NEVER: it is known
} SoccerMemory;

// The sight of a robot at one decision.
typedef struct {
  const ForesightPlayer* me;
  const ForesightMoment* moment;
  Point place;               // [team] own
  int ball_known;            // seen or reported
  uint32_t ball_age;         // [ticks] since that sight
  Point ball, ball_in_team;  // [robot], [team]
  float ball_distance;       // [m]
  Point goal, own_goal;      // [team]
} Sight;

// ---- geometry

static inline Point point(float x, float y) {
  const Point p = {x, y};
  return p;
}
static inline Point add(Point a, Point b) { return point(a.x + b.x, a.y + b.y); }
static inline Point minus(Point a, Point b) { return point(a.x - b.x, a.y - b.y); }
static inline Point times(float f, Point a) { return point(f * a.x, f * a.y); }
static inline float size(Point a) { return sqrtf(a.x * a.x + a.y * a.y); }
static inline float angle_of(Point a) { return atan2f(a.y, a.x); }
static inline Point way_at(float angle) { return point(cosf(angle), sinf(angle)); }
static inline Point turned(Point a, float angle) {
  const Point w = way_at(angle);
  return point(w.x * a.x - w.y * a.y, w.y * a.x + w.x * a.y);
}
static inline float dot(Point a, Point b) { return a.x * b.x + a.y * b.y; }
static inline float cross(Point a, Point b) { return a.x * b.y - a.y * b.x; }
static inline float within(float value, float least, float most) { return fminf(fmaxf(value, least), most); }
static inline Point unit(Point a) { return size(a) > 1e-6f ? times(1 / size(a), a) : point(1, 0); }
static inline float wrapped(float angle) {
  return angle > kPi ? angle - 2 * kPi : angle < -kPi ? angle + 2 * kPi : angle;
}
static inline Point to_robot(const Sight* sight, Point in_team) {
  return turned(minus(in_team, sight->place), -sight->moment->heading);
}
static inline Point to_team(const Sight* sight, Point in_robot) {
  return add(sight->place, turned(in_robot, sight->moment->heading));
}

// ---- beliefs

static inline int hears(const Sight* sight, int player) {
  const ForesightMate* mate = &sight->moment->mates[player - 1];
  return mate->sent != FORESIGHT_NEVER && mate->active && sight->moment->now - mate->sent < kMateMemory;
}
static inline int sees(const Sight* sight, int player) {
  const ForesightOpponent* opponent = &sight->moment->opponents[player - 1];
  return opponent->seen != FORESIGHT_NEVER && sight->moment->now - opponent->seen < kOpponentMemory;
}
static inline Point mate_at(const Sight* sight, int player) {
  return point(sight->moment->mates[player - 1].x, sight->moment->mates[player - 1].y);
}
static inline Point opponent_at(const Sight* sight, int player) {
  return point(sight->moment->opponents[player - 1].x, sight->moment->opponents[player - 1].y);
}

// Returns the sight of this moment. The ball is that of the own eyes while fresh, then the newest report.
static inline Sight look(const ForesightPlayer* me, const ForesightMoment* moment) {
  Sight sight = {.me = me, .moment = moment, .place = {moment->x, moment->y}};
  sight.goal = point(me->field_length / 2, 0), sight.own_goal = point(-me->field_length / 2, 0);
  uint32_t seen = moment->ball_seen;
  sight.ball = point(moment->ball_x, moment->ball_y);
  sight.ball_in_team = to_team(&sight, sight.ball);
  const int fresh = seen != FORESIGHT_NEVER && moment->now - seen < kOwnEyes;
  for (int player = 1; player <= me->players && !fresh; ++player) {
    const ForesightMate* mate = &moment->mates[player - 1];
    if (!hears(&sight, player) || mate->ball_age == FORESIGHT_NEVER || mate->sent < mate->ball_age) continue;
    const uint32_t reported = mate->sent - mate->ball_age;
    if (seen != FORESIGHT_NEVER && reported <= seen) continue;
    seen = reported;
    sight.ball_in_team = point(mate->ball_x, mate->ball_y);
    sight.ball = to_robot(&sight, sight.ball_in_team);
  }
  sight.ball_age = seen == FORESIGHT_NEVER ? FORESIGHT_NEVER : moment->now - seen;
  sight.ball_known = sight.ball_age < kBallMemory;
  sight.ball_distance = size(sight.ball);
  return sight;
}

// Returns the distance [m] from a place to the nearest opponent seen recently; 100 m if none was.
static inline float opponent_distance(const Sight* sight, Point place) {
  float nearest = 100;
  for (int player = 1; player <= sight->me->players; ++player)
    if (sees(sight, player)) nearest = fminf(nearest, size(minus(opponent_at(sight, player), place)));
  return nearest;
}

// ---- avoidance

// Returns the next point [robot] of a way to `target` that stays `radius` from `centre`.
static inline Point round_circle(Point centre, float radius, Point target) {
  const float along = dot(centre, target), off = cross(target, centre), far = size(centre);
  if (along <= 0 || along >= dot(target, target) || fabsf(off) >= radius * size(target)) return target;
  // along the tangent on the nearer side; from inside the circle also outwards
  const float side = off > 0 ? -1 : 1;
  const float sine = radius < far ? radius / far : 1;
  const float cosine = sqrtf(1 - sine * sine);
  const Point ahead = unit(centre), left = point(-ahead.y, ahead.x);
  const Point tangent = add(times(cosine, ahead), times(side * sine, left));
  const Point step = times(fmaxf(far * cosine, 0.25f), tangent);
  return radius > far ? minus(step, times(radius - far, ahead)) : step;
}

// Returns the next point [robot] of a way to `target` round the nearest robot in the way.
static inline Point round_robots(const Sight* sight, Point target) {
  float nearest = fminf(size(target) + kAvoidRadius, kLookAhead);
  Point way = target;
  for (int i = 0; i < 2 * sight->me->players; ++i) {
    const int player = 1 + i / 2, ours = i % 2;
    if (ours ? !hears(sight, player) : !sees(sight, player)) continue;
    const Point other = to_robot(sight, ours ? mate_at(sight, player) : opponent_at(sight, player));
    const Point step = round_circle(other, kAvoidRadius, target);
    if (size(other) >= nearest || (step.x == target.x && step.y == target.y)) continue;
    nearest = size(other), way = step;
  }
  return way;
}

// Walks to a place [robot] with that heading on arrival, kFarthest at a time: a false ball may seem to lie anywhere.
static inline void walk(Point place, float heading, ForesightCommand* command) {
  if (size(place) > kFarthest) place = times(kFarthest, unit(place));
  command->body = FORESIGHT_WALK_TO;
  command->x = place.x, command->y = place.y, command->turn = wrapped(heading);
}

// Goes to a place [team], round robots, and faces the ball there.
static inline void hold(const Sight* sight, Point place, ForesightCommand* command) {
  place.x = within(place.x, sight->own_goal.x, sight->goal.x - 0.2f);
  place.y = within(place.y, -sight->me->field_width / 2, sight->me->field_width / 2);
  const Point target = to_robot(sight, place);
  const float bearing = angle_of(sight->ball);
  command->body = FORESIGHT_STAND;
  if (size(target) > kThere)
    walk(round_robots(sight, target), bearing, command);
  else if (fabsf(bearing) > kFaces)
    walk(point(0, 0), bearing, command);
}

// Keeps the head on the ball. Without it the head looks for marks now and then.
static inline void watch_ball(const Sight* sight, ForesightCommand* command) {
  command->head = FORESIGHT_LOOK_TO;
  command->look[0] = sight->ball.x, command->look[1] = sight->ball.y, command->look[2] = 0.05f;
}

// Keeps away from the ball of the opponents' kick and, but for the goalkeeper, from the own goal area.
static inline void keep_clear(const Sight* sight, ForesightCommand* command) {
  const Point ball = sight->ball_in_team;
  const int walks = command->body == FORESIGHT_WALK_TO;
  const Point wanted = walks ? to_team(sight, point(command->x, command->y)) : sight->place;
  Point place = wanted;
  const int theirs = sight->moment->set_play != FORESIGHT_NO_SET_PLAY && !sight->moment->own_kick;
  if (theirs && sight->ball_distance < kKeepClear - 0.05f)
    place = add(ball, times(kKeepClear, unit(minus(sight->place, ball))));
  else if (theirs && size(minus(wanted, ball)) < kKeepClear)
    place = add(ball, times(kKeepClear, unit(minus(wanted, ball))));
  if (theirs && sight->moment->set_play == FORESIGHT_KICK_OFF) place.x = fminf(place.x, -0.2f);
  const float edge = sight->own_goal.x + 0.8f;  // 0.6 m of the area, and room
  if (sight->me->player != 1 && place.x < edge && fabsf(place.y) < 1.3f) place.x = edge;
  if (place.x == wanted.x && place.y == wanted.y) return;
  const Point target = to_robot(sight, place);
  walk(theirs ? round_circle(sight->ball, kKeepClear - 0.05f, target) : target, walks ? command->turn : 0, command);
}

// ---- roles

// Returns the time [s] until the robot stands behind the ball: the way, the turn, and the walk round the ball.
static inline float time_to_ball(const Sight* sight) {
  if (!sight->ball_known) return 1e6f;
  const Point to_ball = unit(sight->ball);
  const Point goal = unit(minus(sight->goal, sight->ball_in_team));
  const float wrong_side = 1 - dot(turned(to_ball, sight->moment->heading), goal);
  return sight->ball_distance / sight->me->walk_forward + 0.5f * kPi / sight->me->walk_turn * (1 - to_ball.x) +
         0.4f / sight->me->walk_sideward * wrong_side;
}

// Returns the time to the ball [s] of a teammate. A chaser has come nearer since its message.
static inline float mates_time(const Sight* sight, int player) {
  const ForesightMate* mate = &sight->moment->mates[player - 1];
  const float since = (float)(sight->moment->now - mate->sent) / 30;
  return mate->role == FORESIGHT_CHASER && mate->time_to_ball > since ? mate->time_to_ball - since : mate->time_to_ball;
}

// Settles the own role and sends it to the teammates. Player 1 keeps the goal. The quickest of the others chases the
// ball; the one that chases it already keeps it unless another is quicker by kLead. Those farthest back defend, the rest
// supports.
static inline int32_t settle_role(const Sight* sight, SoccerMemory* memory, ForesightCommand* command) {
  const int me = sight->me->player;
  command->time_to_ball = time_to_ball(sight);
  float time[FORESIGHT_MAX_PLAYERS + 1], x[FORESIGHT_MAX_PLAYERS + 1];
  int chaser = 0, others = -1, behind = 0;
  for (int player = 2; player <= sight->me->players; ++player) {
    if (player != me && !hears(sight, player)) continue;
    const int32_t role = player == me ? memory->role : sight->moment->mates[player - 1].role;
    time[player] = player == me ? command->time_to_ball : mates_time(sight, player);
    time[player] -= role == FORESIGHT_CHASER ? kLead : 0;
    x[player] = player == me ? sight->place.x : mate_at(sight, player).x;
    x[player] -= role == FORESIGHT_DEFENDER ? kOrderKeep : 0;
    if (chaser == 0 || time[player] < time[chaser]) chaser = player;
    ++others;
  }
  if (me != 1 && me != chaser)
    for (int player = 2; player <= sight->me->players; ++player)
      if (player != me && player != chaser && hears(sight, player))
        behind += x[player] < x[me] || (x[player] == x[me] && player < me);
  const int defenders = (int)(kDefenders * (float)others + 0.5f);
  memory->role = me == 1              ? FORESIGHT_KEEPER
                 : me == chaser       ? FORESIGHT_CHASER
                 : behind < defenders ? FORESIGHT_DEFENDER
                                      : FORESIGHT_SUPPORTER;
  command->role = memory->role;
  return memory->role;
}

// ---- places

// Returns the place [team] of a supporter: level with the ball or behind it, in a part of the field's width where
// nobody is. It prefers a near place, so that it does not walk to and fro.
static inline Point place_in_space(const Sight* sight) {
  const float x = within(sight->ball_in_team.x - 0.3f, sight->own_goal.x + 1.5f, sight->goal.x - 1);
  Point best = point(x, 0);
  float most = -1e6f;
  for (int i = -2; i <= 2; ++i) {
    const Point place = point(x, 0.32f * (float)i * sight->me->field_width);
    float room = fminf(size(minus(place, sight->ball_in_team)), opponent_distance(sight, place));
    for (int player = 1; player <= sight->me->players; ++player)
      if (player != sight->me->player && hears(sight, player))
        room = fminf(room, size(minus(mate_at(sight, player), place)));
    const float worth = fminf(room, 2) - 0.4f * size(minus(place, sight->place));
    if (worth > most) most = worth, best = place;
  }
  return best;
}

// Returns the place [team] of a defender: on the way from the ball to the own goal.
static inline Point place_between(const Sight* sight) {
  const Point way = minus(sight->ball_in_team, sight->own_goal);
  const float far = size(way);
  return add(sight->own_goal, times(fminf(0.4f * far, fmaxf(far - 1, 0.5f * far)), unit(way)));
}

// ---- the ball

static const int kParts = 20;  // of the goal, looked at one by one

// Returns the middle of the widest gap in the opponents' goal, and in `half` half its width [m], with a third of it as
// room for noise.
static inline Point opening(const Sight* sight, float* half) {
  const float inner = sight->me->goal_width / 2 - 0.1f;
  const Point ball = sight->ball_in_team;
  int first = 0, longest = 0, run = 0;
  for (int i = 0; i <= kParts; ++i) {
    const float y = inner * (2 * (float)i / (float)kParts - 1);
    int hidden = 0;
    for (int player = 1; player <= sight->me->players; ++player) {
      if (!sees(sight, player)) continue;
      const Point other = opponent_at(sight, player);
      if (other.x < ball.x + 0.05f || other.x > sight->goal.x + 0.1f) continue;
      const float share = (other.x - ball.x) / (sight->goal.x - ball.x);
      if (fabsf(ball.y + share * (y - ball.y) - other.y) < 0.25f) hidden = 1;
    }
    run = hidden ? 0 : run + 1;
    if (run > longest) longest = run, first = i - run + 1;
  }
  *half = longest < 2 ? 0 : 0.7f * inner * (float)(longest - 1) / (float)kParts;
  const float middle = longest == 0 ? 0 : inner * ((2 * (float)first + (float)longest - 1) / (float)kParts - 1);
  return point(sight->goal.x, middle);
}

// Returns the direction [rad, robot] for the ball: within the tolerance of the target, and as near as possible to the
// direction from which the robot comes.
static inline float way_of_ball(const Sight* sight, float straight, float tolerance) {
  const float coming = sight->ball_distance > 0.35f ? angle_of(sight->ball) : 0;
  const float off = wrapped(coming - straight), use = kGateShare * tolerance;
  return wrapped(straight + within(off, -use, use));
}

// Walks to where the ball lies `ahead` and `beside` [m] of a robot that faces `way`, round the ball.
static inline void go_behind(const Sight* sight, float way, float ahead, float beside, ForesightCommand* command) {
  const Point target = minus(sight->ball, turned(point(ahead, beside), way));
  const Point step = round_circle(sight->ball, fminf(ahead + 0.07f, 0.3f), target);
  // near the ball the robot fights for it
  walk(sight->ball_distance > 0.6f ? round_robots(sight, step) : step, way, command);
  if (sight->ball_distance < 0.7f) watch_ball(sight, command);
}

// Returns the quickest kick to the front that carries `range` [m], or the longest.
static inline int choose_kick(const Sight* sight, float range) {
  const ForesightKick* kicks = sight->me->kicks;
  int best = -1;
  for (int i = 0; i < sight->me->kick_count; ++i) {
    if (fabsf(kicks[i].direction) > 0.2f) continue;
    const int reaches = kicks[i].range >= range, other = best >= 0 && kicks[best].range >= range;
    const int better = reaches != other ? reaches
                       : best < 0       ? 1
                       : reaches        ? kicks[i].delay < kicks[best].delay
                                        : kicks[i].range > kicks[best].range;
    if (better) best = i;
  }
  return best < 0 ? 0 : best;
}

// Returns whether the ball lies in the gate of the kick: its place before the foot, give or take.
static inline int in_gate(const ForesightKick* kick, Point ball, int left) {
  const float foot = left ? kick->ball_y : -kick->ball_y;
  return fabsf(ball.x - kick->ball_x) < kick->gate_x && fabsf(ball.y - foot) < kick->gate_y;
}

// Kicks the ball to `target` [team], `slack` [m] to each side allowed, but at least `tolerance` [rad]. Goes to the place
// behind the ball until the ball lies in the gate of the kick.
static inline void kick_to(const Sight* sight, SoccerMemory* memory, Point target, float slack, float tolerance,
                           float range, ForesightCommand* command) {
  const Point to_target = minus(target, sight->ball_in_team);
  const float far = fmaxf(size(to_target), 0.1f);
  const float allowed = fmaxf(tolerance, fminf(slack * fabsf(to_target.x) / (far * far), 1.2f));
  const float straight = wrapped(angle_of(to_target) - sight->moment->heading);
  const float way = way_of_ball(sight, straight, allowed);
  const float side = cross(way_at(way), sight->ball);
  if (fabsf(side) > 0.03f) memory->left_foot = side > 0;

  const int index = choose_kick(sight, range);
  const ForesightKick* kick = &sight->me->kicks[index];
  const float speed = size(point(sight->moment->ball_vx, sight->moment->ball_vy));
  const int good = in_gate(kick, sight->ball, memory->left_foot) && fabsf(straight) <= allowed && speed < kStillBall &&
                   sight->moment->ball_seen != FORESIGHT_NEVER &&
                   sight->moment->now - sight->moment->ball_seen < kFreshBall;
  go_behind(sight, way, kick->ball_x, memory->left_foot ? kick->ball_y : -kick->ball_y, command);
  if (good) command->body = FORESIGHT_KICK, command->kick = index, command->kick_left = memory->left_foot;
}

// Pushes the ball along while walking.
static inline void dribble_to(const Sight* sight, Point target, float tolerance, ForesightCommand* command) {
  const float straight = wrapped(angle_of(minus(target, sight->ball_in_team)) - sight->moment->heading);
  const float way = way_of_ball(sight, straight, tolerance);
  const Point ahead = way_at(way);
  const int behind = dot(ahead, sight->ball) > 0 && fabsf(cross(ahead, sight->ball)) < 0.08f;
  go_behind(sight, way, 0.2f, 0, command);
  if (!behind || sight->ball_distance > 0.45f) return;
  walk(add(sight->ball, times(0.4f, ahead)), way, command);
}

// Guards the goal: on an arc in front of it, between ball and goal; sideways or in a squat to a ball that rolls in.
static inline void guard_goal(const Sight* sight, ForesightCommand* command) {
  const Point speed = point(sight->moment->ball_vx, sight->moment->ball_vy);  // [robot]
  const Point rolls = turned(speed, sight->moment->heading);                  // [team]
  const Point ball = sight->ball_in_team;
  if (sight->ball_distance < 3) watch_ball(sight, command);

  // does it roll into the goal?
  const float to_line = ball.x - sight->own_goal.x;
  const float crosses = rolls.x < -0.05f ? ball.y - rolls.y / rolls.x * to_line : 100;
  const float way = rolls.x < -0.05f ? to_line * size(rolls) / -rolls.x : 100;
  const int enters = fabsf(crosses) < sight->me->goal_width / 2 + 0.4f &&
                     dot(rolls, rolls) > 2 * kDeceleration * 0.3f * way && sight->ball_age < kFreshBall;
  if (enters && speed.x < -0.05f && sight->ball.x > 0) {
    // the line of the ball passes the robot at `left`, after `time`
    const float left = sight->ball.y - speed.y / speed.x * sight->ball.x, time = sight->ball.x / -speed.x;
    if (time < 0.8f && fabsf(left) < 0.32f) {
      command->body = FORESIGHT_SQUAT;
      return;
    }
    if (fabsf(left) < 1.5f) {
      command->body = fabsf(left) > 0.05f ? FORESIGHT_WALK_SPEED : FORESIGHT_STAND;
      command->x = command->turn = 0;
      command->y = left > 0 ? sight->me->walk_sideward : -sight->me->walk_sideward;
      return;
    }
  }
  const Point to_ball = unit(minus(ball, sight->own_goal));
  const float widest = sight->me->goal_width / 2 - 0.15f;
  const Point place =
      point(sight->own_goal.x + within(0.7f * to_ball.x, 0.2f, 0.7f), within(0.7f * to_ball.y, -widest, widest));
  hold(sight, place, command);
}

// Searches the ball: looks round with the head, then turns, then walks towards the middle, and so on. With
// `stays` it uses the head only, as a goalkeeper does.
static inline void search_ball(const Sight* sight, SoccerMemory* memory, int stays, ForesightCommand* command) {
  if (memory->searching > sight->moment->now) memory->searching = sight->moment->now;
  const uint32_t time = (sight->moment->now - memory->searching) % 456;
  const float swing = (float)(time % 66) / 66;
  command->body = FORESIGHT_STAND;
  command->head = FORESIGHT_LOOK_ANGLES;
  command->look[0] = 1.3f * (swing < 0.25f ? 4 * swing : swing < 0.75f ? 2 - 4 * swing : 4 * swing - 4);
  command->look[1] = 0.3f, command->look[2] = 0;
  if (time < 66 || stays) return;
  if (time < 216) {
    command->body = FORESIGHT_WALK_SPEED;
    command->x = command->y = 0, command->turn = 0.8f * sight->me->walk_turn;
    return;
  }
  const float x = memory->role == FORESIGHT_DEFENDER ? 0.9f * sight->own_goal.x / 2 : 0;
  const Point target = to_robot(sight, point(x, 0));
  if (size(target) > 0.3f) walk(round_robots(sight, target), -sight->moment->heading, command);
}

#endif
