#include "sim/agent/view.h"

namespace sim::agent {
namespace {

/// Takes the own sight while it is fresh, otherwise the newest report.
void find_ball(View& view) {
  const Ball& own = view.beliefs.ball;
  view.ball_seen = own.seen;
  const bool fresh = own.seen != kNever && view.now - own.seen < ticks(view.settings.habits.trust_eyes);
  int from = -1;
  if (!fresh)
    view.for_each_mate([&](const Mate& mate, int index) {
      if (mate.ball_age == 0xffff || mate.sent < mate.ball_age) return;
      const Tick seen = mate.sent - mate.ball_age;
      if (view.ball_seen != kNever && seen <= view.ball_seen) return;
      view.ball_seen = seen, from = index;
    });
  view.ball_known = view.ball_seen != kNever && view.now - view.ball_seen < ticks(view.settings.habits.forget_ball);

  if (from < 0) {
    view.ball = own.position;
    view.ball_in_team = view.to_team(own.position);
    view.ball_velocity = turned(own.velocity, view.facing);
  } else {
    view.ball_in_team = view.beliefs.mates[from].ball;
    view.ball = view.to_robot(view.ball_in_team);
    view.ball_velocity = {};
  }
  view.ball_distance = length(view.ball);
}

/// Returns the place of the ball at the set play [m, team_field], on the side where the ball was.
Vec2 set_play_place(const View& view, Vec2 ball) {
  const field::Field& field = view.around.rules->field;
  const float side = ball.y != 0 ? sign(ball.y) : view.mind.search_side;
  const float attacked = view.game.own_kick ? 1.f : -1.f;
  switch (view.game.set_play) {
    case Game::SetPlay::corner_kick: return {attacked * view.half_length, side * view.half_width};
    case Game::SetPlay::goal_kick:
      return {-attacked * (view.half_length - field.goal_area_length), 0.5f * side * field.goal_area_width};
    default: return {clamp(ball.x, -view.half_length, view.half_length), side * view.half_width};
  }
}

/// Supposes the ball where the rules put it, until somebody has seen it since the set play began.
void suppose_ball(View& view) {
  const Game& game = view.game;
  if (game.set_play == Game::SetPlay::none || game.set_play == Game::SetPlay::kick_off) return;
  const Tick since = ticks(clamp(game.since_phase, 0, 3600));
  const Tick began = since < view.now ? view.now - since : 0;
  view.ball_put = began;
  const bool ever = view.ball_seen != kNever;
  if (ever && view.ball_seen >= began) return;
  view.ball_in_team = set_play_place(view, ever ? view.ball_in_team : view.mind.ball);
  view.ball = view.to_robot(view.ball_in_team);
  view.ball_distance = length(view.ball);
  view.ball_velocity = {};
  view.ball_seen = began;
  view.ball_known = since < ticks(view.settings.habits.forget_ball);
}

}  // namespace

View::View(const Surroundings& surroundings, const Settings& set, const Game& told, const Beliefs& believed, Tick time,
           const Mind& remembered)
    : around(surroundings), settings(set), game(told), beliefs(believed), mind(remembered), now(time) {
  half_length = 0.5f * surroundings.rules->field.length;
  half_width = 0.5f * surroundings.rules->field.width;
  position = believed.pose.pose.position;
  const SinCos heading = sin_cos(believed.pose.pose.heading);
  facing = {heading.cos, heading.sin};
  find_ball(*this);
  suppose_ball(*this);
}

}  // namespace sim::agent
