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
}

}  // namespace sim::agent
