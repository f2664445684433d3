// A robot's believed pose: odometry drifts, marks correct it, and sometimes the pose flips to the other half.
//
// The believed deviations are consistent: the squared error divided by the variance is 1 on average, without flips.
#pragma once

#include <cmath>
#include <cstdint>

#include "sim/agent/beliefs.h"
#include "sim/perception/perception.h"

namespace sim::perception {

/// The believed motion since the last reading. [robot, present pose]
struct Odometry {
  Vec2 moved;        // [m]
  float way = 0;     // [m] length of `moved`
  float turned = 0;  // [rad]
  Vec2 turn{1, 0};   // unit vector at `turned`
};

/// Returns the robot's true pose. [team_field]
Pose2 true_pose(const World& world, int robot);

/// Looks at the marks after `steps` ticks without a look. One draw settles the effect of odometry and marks on the
/// belief in that time. Then the pose may flip, or the robot may notice its flip.
void look_round(const PerceptionParams& params, const World& world, int robot, Tick steps, agent::Pose& belief,
                Cognition& cognition);

/// Shifts and turns the belief of a robot that fell since its last perception, and makes it that much less sure. The
/// robot notices the fall. An attempt to get up that fails counts as another fall. Draws lost_pose (number: tick).
void lose_pose(const Localisation& model, const World& world, int robot, agent::Pose& belief);

/// Reports whether the body fell in the `steps` ticks before `now`.
inline bool fell(const Body& body, Tick now, Tick steps) {
  return body.doing == Body::Doing::fallen && body.since < now && body.since + steps >= now;
}

// Below: the part of each image, inline because each robot does it in each turn. It draws nothing, except after a fall.

/// Returns the believed motion since `cognition.last`, and moves `last` to the present pose.
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

/// Moves the belief by `odometry`. Looks at the marks in the first image of each `mark_interval` of game time.
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

  if (params.effects.lost_pose && fell(world.bodies[robot], world.tick, steps))
    lose_pose(params.model.localisation, world, robot, belief);

  const Tick interval = ticks(params.model.localisation.mark_interval);
  if (world.tick % interval < steps)
    look_round(params, world, robot, steps < interval ? interval : steps, belief, cognition);
}

}  // namespace sim::perception
