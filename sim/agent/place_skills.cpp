#include "sim/agent/place_skills.h"

#include "sim/agent/features.h"
#include "sim/agent/head.h"
#include "sim/agent/roles.h"
#include "sim/agent/walk.h"

namespace sim::agent {
namespace {

constexpr float kWatched = 0.5f;     // [s] unseen after which the goalkeeper's head searches
constexpr float kWatchAngle = 1.1f;  // [rad] to each side

/// [m, team_field] where the ball is, or was last, or the middle.
Vec2 supposed_ball(const View& view) {
  if (view.ball_known) return view.ball_in_team;
  return view.mind.ball_seen == kNever ? Vec2{} : view.mind.ball;
}

/// Goes to a place in the field and faces the ball.
motion::Command hold(const View& view, Vec2 place, Vec2 ball, float gain) {
  const Vec2 inside{clamp(place.x, -view.half_length, view.half_length - 0.2f),
                    clamp(place.y, -view.half_width, view.half_width)};
  motion::Command command = walk_to_place(view, inside, unit(ball - view.position), gain);
  look_at_ball(view, command);
  return command;
}

/// `place` moved away from the ball to `distance`.
Vec2 away_from(Vec2 place, Vec2 ball, float distance) {
  const Vec2 offset = place - ball;
  return squared_length(offset) >= distance * distance ? place : ball + distance * unit(offset);
}

/// A goalkeeper does not look away from a ball in its half, and looks for one that is not where it was.
void watch(const View& view, motion::Command& command) {
  const bool danger = view.ball_in_team.x < 0;
  if (!view.ball_known || !danger) return look_at_ball(view, command);
  age(view.now, view.beliefs.ball.seen) < kWatched ? keep_eye_on_ball(view, command) : scan(view, command, kWatchAngle);
}

}  // namespace

motion::Command position(const View& view, const Position& with) {
  const Vec2 ball = supposed_ball(view);
  const Vec2 place{with.base * view.half_length + with.follow_x * ball.x + with.x,
                   with.follow_y * ball.y + with.y + with.spread * lane_of(view.mind)};
  return hold(view, away_from(place, ball, with.distance), ball, with.gain);
}

motion::Command block(const View& view, const Block& with) {
  const Vec2 ball = supposed_ball(view);
  const Vec2 to_ball = ball - view.own_goal();
  const float far = length(to_ball);
  const float farthest = far > with.distance ? far - with.distance : 0.5f * far;
  const float out = with.share * far < farthest ? with.share * far : farthest;
  const Vec2 way = unit(to_ball);
  return hold(view, view.own_goal() + out * way + (with.spread * lane_of(view.mind)) * left_of(way), ball, with.gain);
}

motion::Command keep_goal(const View& view, const KeepGoal& with) {
  const Vec2 ball = supposed_ball(view);
  const Vec2 way = unit(ball - view.own_goal());
  motion::Command command;

  // a ball that rolls into the goal: sideways to where it passes
  if (value_of(Feature::ball_in_goal_soon, view) > 0) {
    const float left = value_of(Feature::crossing_left, view);
    const bool soon = value_of(Feature::crossing_time, view) < with.squat_time;
    if (soon && std::abs(left) < with.squat_reach) {
      command.body = motion::Command::Body::squat;
      keep_eye_on_ball(view, command);
      return command;
    }
    if (std::abs(left) < 1.5f) {
      // sidewards as fast as it can: a body that walks to a place would turn towards it first
      if (std::abs(left) > 0.05f) {
        command.body = motion::Command::Body::walk_speed;
        command.walk = {0, std::copysign(view.around.motion->walk.sideward, left)};
      }
      keep_eye_on_ball(view, command);
      return command;
    }
  }

  // the arc is flattened to the goal's width, so that it stands in front of the goal and not beside it
  const float widest = 0.5f * view.around.field->goal_width - 0.15f;
  const Vec2 place{-view.half_length + clamp(with.radius * way.x, 0.2f, with.radius),
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

  // inside the own half; nobody in the circle but who kicks off
  const float margin = 0.25f;
  place.x = clamp(place.x, -view.half_length, -margin);
  const float circle = view.around.field->centre_circle_radius + margin;
  const bool kicks_off = ours && index == 1;
  return kicks_off ? place : away_from(place, {}, circle);
}

motion::Command get_ready(const View& view) {
  const Vec2 place = ready_place(view);
  motion::Command command = walk_to_place(view, place, unit(Vec2{} - place), 1);
  scan(view, command, 0.7f);
  return command;
}

}  // namespace sim::agent
