#include "sim/agent/place_skills.h"

#include "sim/agent/features.h"
#include "sim/agent/head.h"
#include "sim/agent/roles.h"
#include "sim/agent/walk.h"

namespace sim::agent {
namespace {

constexpr float kWatched = 0.5f;     // [s] the goalkeeper's head searches a ball unseen for longer
constexpr float kWatchAngle = 1.1f;  // [rad] to each side

constexpr float kSideStepReach =
    1.5f;                             // [m] the goalkeeper steps sideways to a ball that passes nearer; farther: walks
constexpr float kInLine = 0.05f;      // [m] a ball that passes nearer hits the legs: stand still
constexpr float kInsidePost = 0.15f;  // [m] half a robot's width: the keeper's arc ends this far inside the posts
constexpr float kOffLine = 0.2f;      // [m] the keeper's arc stays this far in front of the goal line

constexpr float kOffEndLine = 0.2f;    // [m] places stay this far from the opponents' goal line
constexpr float kReadyMargin = 0.25f;  // [m] from the halfway line and the circle at a kick-off: half a robot, and more
constexpr float kReadyScan = 0.7f;     // [rad] the head's swing on the way to the kick-off place

/// Returns whether the robot stands at its place: it walks until it is near, and then stays until it is `far` [m] off.
bool stays(const View& view, Mind& mind, Vec2 place, float far) {
  const float reach = mind.holds ? far : view.settings.habits.walk_tolerance;
  return mind.holds = squared_length(place - view.position) < reach * reach;
}

/// Goes to a place in the field, stays there, and faces the ball.
motion::Command hold(const View& view, Mind& mind, Vec2 place, Vec2 ball, float gain) {
  const Vec2 inside{clamp(place.x, -view.half_length, view.half_length - kOffEndLine),
                    clamp(place.y, -view.half_width, view.half_width)};
  const Vec2 face = unit(ball - view.position);
  motion::Command command = stays(view, mind, inside, view.settings.habits.walk_again)
                                ? turn_to(view, turned_back(face, view.facing))
                                : walk_to_place(view, inside, face, gain);
  look_at_ball(view, command);
  return command;
}

/// Returns `place`, moved away from the ball to `distance`.
Vec2 away_from(Vec2 place, Vec2 ball, float distance) {
  const Vec2 offset = place - ball;
  return squared_length(offset) >= distance * distance ? place : ball + distance * unit(offset);
}

/// Returns the side of the ball on which the robot is, +1 left or -1 right. It is the other side if a place `aside` [m]
/// from the ball would be outside the field.
float open_side(const View& view, Vec2 ball, float aside) {
  const float off = view.position.y - ball.y;
  const float side = off != 0 ? sign(off) : view.mind.search_side;
  return side * ball.y + aside > view.half_width ? -side : side;
}

/// Returns whether the robot has the lowest number of the field players that are not known to be off the field.
bool is_first(const View& view) {
  for (int i = 0; i + 1 < view.game.players; ++i) {
    const Mate& mate = view.beliefs.mates[i];
    const int player = view.player_of_mate(i);
    const bool is_away = mate.sent != kNever && !mate.active;
    if (player > 1 && player < view.game.player && !is_away) return false;
  }
  return view.game.player > 1;
}

/// Keeps the goalkeeper's eyes on a ball in its half, and searches a ball that is not where it was.
void watch(const View& view, motion::Command& command) {
  const bool danger = view.ball_in_team.x < 0;
  if (!view.ball_known || !danger) return look_at_ball(view, command);
  age(view.now, view.beliefs.ball.seen) < kWatched ? keep_eye_on_ball(view, command) : scan(view, command, kWatchAngle);
}

}  // namespace

Vec2 supposed_ball(const View& view) {
  if (view.ball_known) return view.ball_in_team;
  return view.mind.ball_seen == kNever ? Vec2{} : view.mind.ball;
}

motion::Command position(const View& view, Mind& mind, const Position& with) {
  const Vec2 ball = supposed_ball(view);
  const float y = with.follow_y * ball.y + with.y + with.spread * lane_of(view.mind) +
                  with.aside * open_side(view, ball, with.aside);
  const Vec2 place{with.base * view.half_length + with.follow_x * ball.x + with.x, y};
  return hold(view, mind, away_from(place, ball, with.distance), ball, with.gain);
}

motion::Command block(const View& view, Mind& mind, const Block& with) {
  const Vec2 ball = supposed_ball(view);
  const Vec2 to_ball = ball - view.own_goal();
  const float far = length(to_ball);
  const float farthest = far > with.distance ? far - with.distance : 0.5f * far;
  const float between = with.share * far < farthest ? with.share * far : farthest;
  const float out = between > with.from_goal ? between : with.from_goal;
  const Vec2 way = unit(to_ball);
  // nearer to the goal the way to it is narrower
  const float width = far < view.half_length ? with.spread * far / view.half_length : with.spread;
  const Vec2 place = view.own_goal() + out * way + (width * lane_of(view.mind)) * left_of(way);
  return hold(view, mind, away_from(place, ball, with.distance), ball, with.gain);
}

motion::Command keep_goal(const View& view, Mind& mind, const KeepGoal& with) {
  const Vec2 ball = supposed_ball(view);
  const Vec2 way = unit(ball - view.own_goal());
  motion::Command command;

  // a ball that rolls into the goal: sideways to where it passes
  if (view.ball_known && rolls_into_own_goal(view)) {
    const Crossing passes = crossing(view);
    const float off = std::abs(passes.left);  // NaN when it does not pass: every comparison is false
    if (passes.time < with.squat_time && off < with.squat_reach) {
      command.body = motion::Command::Body::squat;
      keep_eye_on_ball(view, command);
      return command;
    }
    if (off < kSideStepReach) {
      // walk_speed, because a body that walks to a place would turn towards it first
      if (off > kInLine) {
        command.body = motion::Command::Body::walk_speed;
        command.walk = {0, std::copysign(view.around.motion->walk.sideward, passes.left)};
      }
      keep_eye_on_ball(view, command);
      return command;
    }
  }

  // the arc is flattened to the goal's width, so that it stands in front of the goal and not beside it
  const float widest = 0.5f * view.around.rules->field.goal_width - kInsidePost;
  const Vec2 place{-view.half_length + clamp(with.radius * way.x, kOffLine, with.radius),
                   clamp(with.radius * way.y, -widest, widest)};
  const Vec2 target = view.to_robot(place);
  const Vec2 face = turned_back(unit(ball - view.position), view.facing);
  command = stays(view, mind, place, with.step) ? turn_to(view, face) : walk_in_robot(view, target, angle_of(face), 1);
  watch(view, command);
  return command;
}

Vec2 ready_place(const View& view) {
  const Formation& formation = view.settings.formation;
  const bool ours = view.game.own_kick, kicks_off = ours && is_first(view);
  const int own = view.game.player >= 1 && view.game.player <= kMaxPlayers ? view.game.player - 1 : 0;
  const int index = kicks_off ? 1 : own;
  const Vec2 share = ours ? formation.ours[index] : formation.theirs[index];
  Vec2 place{share.x * view.half_length, share.y * view.half_width};

  // inside the own half; only the robot that kicks off may be in the circle
  place.x = clamp(place.x, -view.half_length, -kReadyMargin);
  const float circle = view.around.rules->field.centre_circle_radius + kReadyMargin;
  return kicks_off ? place : away_from(place, {}, circle);
}

motion::Command get_ready(const View& view) {
  const Vec2 place = ready_place(view);
  motion::Command command = walk_to_place(view, place, unit(Vec2{} - place), 1);
  scan(view, command, kReadyScan);
  return command;
}

}  // namespace sim::agent
