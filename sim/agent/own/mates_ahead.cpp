// Example of a feature: the number of teammates that are nearer to the opponents' goal than the ball.
#include "sim/agent/own.h"

namespace sim::agent::own {
namespace {

float compute(const View& view) {
  const float of_ball = squared_length(view.goal() - view.ball_in_team);
  float count = 0;
  view.for_each_mate([&](const Mate& mate, int) {
    if (squared_length(view.goal() - mate.pose.position) < of_ball) count += 1;
  });
  return count;
}

}  // namespace

FeatureInfo mates_ahead() {
  return {.compute = compute,
          .needs_ball = true,
          .lateral = false,
          .kind = FeatureInfo::Kind::number,
          .name = "mates_ahead",
          .unit = "robots",
          .least = 0,
          .most = 6,
          .names = nullptr,
          .about = "teammates nearer to the opponents' goal than the ball"};
}

}  // namespace sim::agent::own
