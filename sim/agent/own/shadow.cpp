// Example of a skill: stays between the ball and the own goal, out of a kick's way, and looks at the ball.
#include "sim/agent/head.h"
#include "sim/agent/own.h"

namespace sim::agent::own {
namespace {

struct Shadow {
  float distance = 0.8f;  // [m]
  float gain = 1;

  template <class Self, class See>
  static constexpr void visit(Self& self, See&& see) {
    see("distance", self.distance, Range{"m", 0.3f, 5}, "from the ball");
    see("gain", self.gain, kGainRange, "share of the greatest speed");
  }
};

motion::Command run(const View& view, Mind& mind, const Shadow& with) {
  if (!view.ball_known) return look_round(view, mind, {});
  const Vec2 place = view.ball_in_team + with.distance * unit(view.own_goal() - view.ball_in_team);
  motion::Command command;
  command.body = motion::Command::Body::walk_to;
  command.walk = view.to_robot(place);
  command.turn = atan2(view.ball.y, view.ball.x);
  command.gain = with.gain;
  keep_eye_on_ball(view, command);
  return command;
}

}  // namespace

SkillInfo shadow() {
  return skill<Shadow, run>("shadow", "stays behind the ball as seen from the own goal, facing it");
}

}  // namespace sim::agent::own
