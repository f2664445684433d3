#include "sim/agent/view.h"

namespace sim::agent {
namespace {

constexpr Tick kOldImage = 5;          // [ticks] of a set play in which images may still show the ball's former place
constexpr float kPlacedByEyes = 1.5f;  // [m] nearer, the eyes err less than localisation does
constexpr float kEyesFresh = 3;        // [s] after which a near ball is supposed at its place again

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

/// Returns the place of the ball at the set play [m, team_field], on the side of `ball`.
Vec2 set_play_place(const View& view, Vec2 ball) {
  const field::Field& field = view.around.rules->field;
  const float side = ball.y != 0 ? sign(ball.y) : view.mind.search_side;
  const float attacked = view.game.own_kick ? 1.f : -1.f;
  switch (view.game.set_play) {
    case Game::SetPlay::kick_off: return {};
    case Game::SetPlay::corner_kick: return field::corner_kick_place(field, attacked, side);
    case Game::SetPlay::goal_kick: return field::goal_kick_place(field, -attacked, side);
    default: return field::kick_in_place(field, ball.x, side);
  }
}

/// Supposes the ball where the rules put it: it lies there until it is touched, and then the set play is over. A sight
/// since the set play began tells on which side; only from near the own eyes place the ball better than the rules do.
void suppose_ball(View& view) {
  const Game& game = view.game;
  if (game.set_play == Game::SetPlay::none || game.phase != Game::Phase::playing) return;
  const Tick since = ticks(clamp(game.since_phase, 0, 3600));
  const Tick began = since < view.now ? view.now - since : 0;
  view.ball_put = began;
  const auto seen_since = [&](Tick seen) { return seen != kNever && seen >= began + kOldImage; };
  const bool near = length(view.beliefs.ball.position) < kPlacedByEyes;
  if (near && seen_since(view.beliefs.ball.seen) && view.now - view.beliefs.ball.seen < ticks(kEyesFresh)) return;

  const bool newly_seen = view.ball_known && seen_since(view.ball_seen);
  view.ball_in_team = set_play_place(view, newly_seen ? view.ball_in_team : view.mind.ball);
  view.ball = view.to_robot(view.ball_in_team);
  view.ball_distance = length(view.ball);
  view.ball_velocity = {};
  if (!newly_seen) view.ball_seen = began;
  view.ball_known = true;
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
