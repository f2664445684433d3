// An example of a skill: stays between the ball and the own goal, out of a kick's way, and looks at the ball.
#include "sim/agent/head.h"
#include "sim/agent/own.h"

namespace sim::agent::own {
namespace {

motion::Command run(const float* with, const View& view, Mind&) {
  if (!view.ball_known) return look_round(view, 1);
  const Vec2 place = view.ball_in_team + with[0] * unit(view.own_goal() - view.ball_in_team);
  motion::Command command;
  command.body = motion::Command::Body::walk_to;
  command.walk = view.to_robot(place);
  command.turn = atan2(view.ball.y, view.ball.x);
  command.gain = with[1];
  keep_eye_on_ball(view, command);
  return command;
}

}  // namespace

OwnSkill shadow() {
  return {{"shadow",
           "stays behind the ball as seen from the own goal, facing it",
           2,
           {{"distance", "m", 0.3f, 5, 0.8f, false, nullptr, "from the ball"},
            {"gain", "", 0.1f, 1, 1, false, nullptr, "share of the greatest speed"}}},
          run};
}

}  // namespace sim::agent::own
