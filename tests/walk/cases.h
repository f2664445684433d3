// The cases in which walks are judged, and how they are played.
#pragma once

#include <cstdint>
#include <functional>
#include <map>
#include <memory>
#include <string>

#include "robot/nao/walk/parameters.h"
#include "tests/walk/foreign_walk.h"
#include "tests/walk/trial.h"

namespace robot::nao::walk {

inline constexpr int kDirections = 8;  // of pushes: 0 to the front, then counter-clockwise

/// Everything that a case changes.
struct Case {
  std::function<Plan(std::uint64_t seed, int repetition)> plan;
  int repetitions = 1;  // of each robot
  double turf = 0;      // [m]
  double delay = 0;     // [s] more
  double wider = 1;
  double warms = 0;  // [s] DrawnRobot::warms
  bool ball = false;
  bool ode = false;  // in the second engine
  Parameters parameters = {};
};

/// One push of `impulse` [N s] in each of eight directions, at a random phase of a step, while the robot obeys `command`.
Case pushes(double impulse, const Command& command);
/// Small pushes again and again, from kShoved [s] on, while the robot obeys `command`: another robot walks at 0.2 m/s and runs
/// into it with each step. The eight directions are eight trials.
Case shoves(const Command& command);
inline constexpr double kShoved = 2;  // [s]
/// The same command for `duration` [s], after a moment in which the robot stands.
Case constant(const Command& command, double duration = 40);
/// Returns all cases of the bench by name.
const std::map<std::string, Case>& cases();

/// The walk under test.
struct Tested {
  Legs stand;
  double hip_height;                             // [m]
  std::function<std::unique_ptr<Gait>()> begin;  // returns null if there is no new gait
};

Tested ours(const Parameters& parameters);
/// `walk` outlives the result.
Tested theirs(const ForeignWalk& walk);

/// Plays the case with `robots` robots of this class, which have the seeds from `first_seed` on. A robot that fell before
/// its push is left out, because it proves nothing about the push. Returns false if the walk gives no gait.
bool play(const Case& one, const Tested& tested, Servos servos, std::uint64_t first_seed, int robots,
          const std::function<void(const Outcome& outcome, const Plan& plan, int repetition)>& see);

}  // namespace robot::nao::walk
