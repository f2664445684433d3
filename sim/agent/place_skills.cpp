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

/// Goes to a place in the field and faces the ball.
motion::Command hold(const View& view, Vec2 place, Vec2 ball, float gain) {
  const Vec2 inside{clamp(place.x, -view.half_length, view.half_length - kOffEndLine),
                    clamp(place.y, -view.half_width, view.half_width)};
  motion::Command command = walk_to_place(view, inside, unit(ball - view.position), gain);
  look_at_ball(view, command);
  return command;
}

/// Returns `place`, moved away from the ball to `distance`.
Vec2 away_from(Vec2 place, Vec2 ball, float distance) {
  const Vec2 offset = place - ball;
  return squared_length(offset) >= distance * distance ? place : ball + distance * unit(offset);
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

motion::Command position(const View& view, Mind&, const Position& with) {
  const Vec2 ball = supposed_ball(view);
  const Vec2 place{with.base * view.half_length + with.follow_x * ball.x + with.x,
                   with.follow_y * ball.y + with.y + with.spread * lane_of(view.mind)};
  return hold(view, away_from(place, ball, with.distance), ball, with.gain);
}

motion::Command block(const View& view, Mind&, const Block& with) {
  const Vec2 ball = supposed_ball(view);
  const Vec2 to_ball = ball - view.own_goal();
  const float far = length(to_ball);
  const float farthest = far > with.distance ? far - with.distance : 0.5f * far;
  const float out = with.share * far < farthest ? with.share * far : farthest;
  const Vec2 way = unit(to_ball);
  return hold(view, view.own_goal() + out * way + (with.spread * lane_of(view.mind)) * left_of(way), ball, with.gain);
}

motion::Command keep_goal(const View& view, Mind&, const KeepGoal& with) {
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
  command = squared_length(target) < with.step * with.step ? turn_to(view, face)
                                                           : walk_in_robot(view, target, angle_of(face), 1);
  watch(view, command);
  return command;
}

Vec2 ready_place(const View& view) {
  const Formation& formation = view.settings.formation;
  const bool ours = view.game.own_kick;
  const int index = view.game.player >= 1 && view.game.player <= kMaxPlayers ? view.game.player - 1 : 0;
  const Vec2 share = ours ? formation.ours[index] : formation.theirs[index];
  Vec2 place{share.x * view.half_length, share.y * view.half_width};

  // inside the own half; only the robot that kicks off may be in the circle
  place.x = clamp(place.x, -view.half_length, -kReadyMargin);
  const float circle = view.around.rules->field.centre_circle_radius + kReadyMargin;
  const bool kicks_off = ours && index == 1;
  return kicks_off ? place : away_from(place, {}, circle);
}

motion::Command get_ready(const View& view) {
  const Vec2 place = ready_place(view);
  motion::Command command = walk_to_place(view, place, unit(Vec2{} - place), 1);
  scan(view, command, kReadyScan);
  return command;
}

}  // namespace sim::agent
