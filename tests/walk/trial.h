// Trials of a walk on simulated robots.
#pragma once

#include <functional>
#include <memory>
#include <vector>

#include "robot/nao/walk/sensors.h"
#include "tests/walk/drawn_robot.h"
#include "tests/walk/physics.h"

namespace robot::nao::walk {

/// A walk under test. It sees only sensors and commands.
class Gait {
 public:
  virtual ~Gait() = default;
  virtual Legs tick(const Sensors& sensors, const Command& command, double dt) = 0;
  /// Reports whether it makes steps.
  virtual bool steps() const = 0;
  /// Reports whether this step kicks.
  virtual bool kicks() const { return false; }
};

/// A blow to the torso. It takes 50 ms.
struct Push {
  double time = 0;       // [s]
  double impulse = 0;    // [N s]
  double direction = 0;  // [rad] in the robot's frame, 0 forward, > 0 to the left
};

/// The course of one trial.
struct Plan {
  double duration = 40;                    // [s]
  double dt = 0.012;                       // [s] from frame to frame; LoLA has 12 ms
  std::function<Command(double)> command;  // by time [s]
  std::vector<Push> pushes;
  bool with_ball = false;  // puts the ball down when a step with a kick begins
  double ball_ahead = 0;   // [m] from the torso
  double ball_left = 0;    // [m]
};

/// The result of one trial.
struct Outcome {
  bool fell = false;          // a tilt of more than 60°, or the torso below 0.2 m
  double time = 0;            // [s] of the fall, or of the end
  double direction = 0;       // [rad] of the fall, as Push::direction
  double forward = 0;         // [m] sum of displacements along the body, every 0.2 s, from 2 s on
  double left = 0;            // [m] likewise to its left
  double turned = 0;          // [rad] likewise
  double path = 0;            // [m] of the torso, likewise; it counts the sway
  double measured = 0;        // [s] in which these were summed
  double slow = 0;            // [s] longest time with less than half of the commanded forward speed
  double last_step = 0;       // [s] time at which it last made a step
  double ball_speed = 0;      // [m/s] greatest speed of the ball
  double ball_direction = 0;  // [rad] of that velocity, in the robot's frame

  bool failed() const { return fell || slow > 10; }
};

/// Lets a robot follow a plan. `seed` settles the noise and the ground. `stand` are the angles of a standing robot and
/// `hip_height` [m] the height of its hip above the soles.
Outcome run(Physics& physics, Gait& gait, const DrawnRobot& robot, std::uint64_t seed, const Legs& stand,
            double hip_height, const Plan& plan);

}  // namespace robot::nao::walk
