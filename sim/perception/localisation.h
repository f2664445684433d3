// Where a robot believes it is: odometry that drifts, marks that correct it, and now and then the wrong way round.
//
// The deviations are honest: the squared error divided by the variance is 1 on average, flips left aside.
#pragma once

#include <cmath>
#include <cstdint>

#include "sim/agent/beliefs.h"
#include "sim/perception/perception.h"

namespace sim::perception {

/// How the robot believes it moved since it was last asked. [robot, as it stands now]
struct Odometry {
  Vec2 moved;        // [m]
  float way = 0;     // [m] the length of it
  float turned = 0;  // [rad]
  Vec2 turn{1, 0};   // the unit vector at `turned`
};

/// Where the robot stands. [team_field]
Pose2 true_pose(const World& world, int robot);

/// Looks at the marks after `steps` ticks without a look. One draw settles all that odometry and the marks did to the
/// belief meanwhile; then the robot may turn the field round, or notice that it has.
void look_round(const PerceptionParams& params, const World& world, int robot, Tick steps, agent::Pose& belief,
                Cognition& cognition);

// What each image does, inline because every robot does it every tick. It draws nothing.

/// What the body did since `cognition.last`, by the robot's own reckoning, and moves `last` there.
inline Odometry read_odometry(const Body& body, Cognition& cognition) {
  Odometry odometry;
  if (body.position != cognition.last.position) {
    odometry.moved = cognition.odometry_scale * turned_back(body.position - cognition.last.position, body.facing);
    odometry.way = length(odometry.moved);
  }
  if (body.heading != cognition.last.heading) {
    odometry.turned = cognition.turn_scale * normalized(body.heading - cognition.last.heading);
    odometry.turn = direction_of_small(odometry.turned);
  }
  cognition.last = {body.position, body.heading};
  return odometry;
}

/// Moves the belief by `odometry`; looks at the marks in the first image of each `mark_interval` of the game's clock.
[[gnu::always_inline]] inline void localise(const PerceptionParams& params, const World& world, int robot, Tick steps,
                                            const Odometry& odometry, agent::Pose& belief, Cognition& cognition) {
  if (!params.effects.odometry_drift) {
    belief = {.pose = true_pose(world, robot)};
    return;
  }
  if (odometry.turned != 0) {
    belief.pose.heading = normalized(belief.pose.heading + odometry.turned);
    const float turned = static_cast<float>(cognition.turned) + std::fabs(odometry.turned) * (1 / kTurnUnit) + 0.5f;
    cognition.turned = static_cast<std::uint16_t>(turned < 65535 ? turned : 65535);
  }
  if (odometry.way > 0) {
    belief.pose.position += turned(odometry.moved, direction(belief.pose.heading));
    cognition.walked += odometry.way;
  }

  const Tick interval = ticks(params.model.localisation.mark_interval);
  if (world.tick % interval < steps)
    look_round(params, world, robot, steps < interval ? interval : steps, belief, cognition);
}

}  // namespace sim::perception
