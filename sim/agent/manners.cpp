#include "sim/agent/manners.h"

#include "sim/agent/walk.h"

namespace sim::agent {
namespace {

using Body = motion::Command::Body;

constexpr float kMargin = 0.05f;  // [m] tolerance of the distance from the ball

/// Changes the command to walk to `place` [team_field]. The heading stays as commanded.
void divert(const View& view, motion::Command& command, Vec2 place) {
  if (command.body != Body::walk_to) command.turn = 0, command.gain = 1;
  command.body = Body::walk_to;
  command.walk = view.to_robot(place);
}

/// Returns the distance [m] that the robot keeps from the ball of the opponents' kick: its habit, at least the rule.
float clear_of_ball(const View& view) {
  const float habit = view.settings.habits.keep_clear, rule = view.around.rules->clear_distance + kMargin;
  return habit > rule ? habit : rule;
}

/// Returns whether the robot is too near to the ball of the opponents' kick.
bool too_near(const View& view) { return view.ball_distance < clear_of_ball(view) - kMargin; }

/// Returns the place [team_field] at `clear` [m] from the ball in the direction `way`, or in its mirror image where that
/// would be outside the field.
Vec2 beside_ball(const View& view, Vec2 way, float clear) {
  const Vec2 ball = view.ball_in_team;
  Vec2 offset = clear * unit(way);
  if (std::abs(ball.x + offset.x) > view.half_length) offset.x = -offset.x;
  if (std::abs(ball.y + offset.y) > view.half_width) offset.y = -offset.y;
  return ball + offset;
}

void keep_clear(const View& view, motion::Command& command) {
  const float clear = clear_of_ball(view);
  if (command.body == Body::kick) command.body = Body::stand;

  const auto walk_round_ball = [&] {
    command.walk = round_circle(view, view.ball, clear - kMargin, command.walk, view.mind.search_side);
  };

  // a robot that is too near goes straight away from the ball, or round it where the field ends
  if (too_near(view)) {
    divert(view, command, beside_ball(view, view.position - view.ball_in_team, clear));
    return walk_round_ball();
  }

  // other robots avoid places that are too near, and walk round the circle
  const Vec2 wanted = command.body == Body::walk_to ? view.to_team(command.walk) : view.position;
  const Vec2 from_ball = wanted - view.ball_in_team;
  const bool inside = squared_length(from_ball) < clear * clear;
  Vec2 place = inside ? beside_ball(view, from_ball, clear) : wanted;
  if (view.game.set_play == Game::SetPlay::kick_off && place.x > -0.2f) place.x = -0.2f;
  if (!(place == wanted)) {
    divert(view, command, place);
    command.walk = round_robots(view, command.walk);
  }
  if (command.body == Body::walk_to) walk_round_ball();
}

void leave_goal_area(const View& view, motion::Command& command) {
  const field::Field& field = view.around.rules->field;
  const Vec2 place = view.to_team(command.walk);
  const float edge = -view.half_length + field.goal_area_length + 0.15f;
  if (place.x < edge && std::abs(place.y) < 0.5f * field.goal_area_width + 0.15f)
    divert(view, command, {edge, place.y});
}

}  // namespace

void mind_manners(const View& view, motion::Command& command) {
  const bool theirs = view.game.set_play != Game::SetPlay::none && !view.game.own_kick && view.ball_known;
  if (theirs) keep_clear(view, command);
  // getting away from the ball comes first
  if (theirs && too_near(view)) return;
  const bool stays_out = view.around.rules->illegal_defender && view.game.player != 1;
  if (stays_out && command.body == Body::walk_to) leave_goal_area(view, command);
}

}  // namespace sim::agent
