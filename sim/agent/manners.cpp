#include "sim/agent/manners.h"

#include "sim/agent/walk.h"

namespace sim::agent {
namespace {

using Body = motion::Command::Body;

/// Walks to `place` instead [team_field]; the heading stays as commanded.
void divert(const View& view, motion::Command& command, Vec2 place) {
  if (command.body != Body::walk_to) command.turn = 0, command.gain = 1;
  command.body = Body::walk_to;
  command.walk = view.to_robot(place);
}

void keep_clear(const View& view, motion::Command& command) {
  const float clear = view.settings.habits.keep_clear;
  if (command.body == Body::kick) command.body = Body::stand;

  // out of the circle, and round it
  const Vec2 wanted = command.body == Body::walk_to ? view.to_team(command.walk) : view.position;
  const Vec2 from_ball = wanted - view.ball_in_team;
  const bool inside = squared_length(from_ball) < clear * clear;
  Vec2 place = inside ? view.ball_in_team + clear * unit(from_ball) : wanted;
  if (view.game.set_play == Game::SetPlay::kick_off && place.x > -0.2f) place.x = -0.2f;
  const bool elsewhere = !(place == wanted);
  if (elsewhere) divert(view, command, place);
  if (command.body == Body::walk_to)
    command.walk = round_circle(view.ball, clear - 0.05f, command.walk, view.mind.search_side);
}

void leave_goal_area(const View& view, motion::Command& command) {
  const field::Field& field = *view.around.field;
  const Vec2 place = view.to_team(command.walk);
  const float edge = -view.half_length + field.goal_area_length + 0.15f;
  if (place.x < edge && std::abs(place.y) < 0.5f * field.goal_area_width + 0.15f)
    divert(view, command, {edge, place.y});
}

}  // namespace

motion::Command mannerly(const View& view, motion::Command command) {
  if (view.game.set_play != Game::SetPlay::none && !view.game.own_kick && view.ball_known) keep_clear(view, command);
  if (view.game.player != 1 && command.body == Body::walk_to) leave_goal_area(view, command);
  return command;
}

}  // namespace sim::agent
