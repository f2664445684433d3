#include "sim/perception/perception.h"

#include <array>

#include "sim/math/lanes.h"
#include "sim/perception/ball_filter.h"
#include "sim/perception/ball_sight.h"
#include "sim/perception/localisation.h"
#include "sim/perception/odometry.h"
#include "sim/perception/robots_sight.h"

namespace sim::perception {
namespace {

/// Draws the scale errors of this robot's odometry in this game.
void draw_odometry(const Localisation& model, const World& world, int robot, Cognition& cognition) {
  const auto words = draw(world.key, static_cast<std::uint32_t>(robot), Draw::odometry_bias, 0);
  const auto biases = normals(words[0], words[1]);
  cognition.odometry_scale = 1 + model.bias * biases[0];
  cognition.turn_scale = 1 + model.bias * biases[1];
}

/// Returns the true pose with the error of a robot that was put down by hand.
agent::Pose rough_pose(const Localisation& model, const World& world, int robot) {
  agent::Pose belief{true_pose(world, robot), model.start_deviation, model.start_deviation_heading};
  // shares the address of a look at the marks in the same tick: that look's result is discarded now
  const auto words = draw(world.key, static_cast<std::uint32_t>(robot), Draw::pose_correction, world.tick);
  const auto shift = normals(words[0], words[1]);
  const auto twist = normals(words[2], words[3]);
  belief.pose.position += belief.deviation * Vec2{shift[0], shift[1]};
  belief.pose.heading = normalized(belief.pose.heading + belief.deviation_heading * twist[0]);
  return belief;
}

/// Corrects the believed balls of at most `Most` robots. One robot should not pay for the room of many.
template <std::size_t Most>
void follow_ball(const PerceptionParams& params, std::span<const Look> looks) {
  std::array<BallPercept, Most> percepts;
  look_for_ball(params, looks, percepts);
  update(params, looks, percepts);
}

}  // namespace

void enter(const PerceptionParams& params, const World& world, int robot, agent::Beliefs& beliefs,
           Cognition& cognition) {
  const Body& body = world.bodies[robot];
  beliefs.ball = unknown_ball(params.model.filter);
  beliefs.pose = {.pose = true_pose(world, robot)};
  cognition.last = {body.position, body.heading};
  cognition.walked = 0;
  cognition.turned = 0;
  cognition.flipped = false;
  if (!params.effects.odometry_drift) return;
  draw_odometry(params.model.localisation, world, robot, cognition);
  beliefs.pose = rough_pose(params.model.localisation, world, robot);
}

void perceive(const PerceptionParams& params, std::span<const Look> looks) {
  predict(params, looks);
  localise(params, looks);
  if (looks.size() <= kLanes)
    follow_ball<kLanes>(params, looks);
  else
    follow_ball<kMostLooks>(params, looks);
  look_for_opponents(params, looks);
}

}  // namespace sim::perception
