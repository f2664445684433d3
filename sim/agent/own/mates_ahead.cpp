// An example of a feature: how many teammates are nearer to the opponents' goal than the ball.
#include <limits>

#include "sim/agent/own.h"

namespace sim::agent::own {
namespace {

float value(const View& view) {
  if (!view.ball_known) return std::numeric_limits<float>::quiet_NaN();
  const float of_ball = squared_length(view.goal() - view.ball_in_team);
  float count = 0;
  view.for_each_mate([&](const Mate& mate, int) {
    if (squared_length(view.goal() - mate.pose.position) < of_ball) count += 1;
  });
  return count;
}

}  // namespace

OwnFeature mates_ahead() {
  return {{"mates_ahead", FeatureInfo::Kind::number, "robots", 0, 6, false, nullptr,
           "teammates nearer to the opponents' goal than the ball"},
          value};
}

}  // namespace sim::agent::own
