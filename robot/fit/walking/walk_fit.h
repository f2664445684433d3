// The parameters of the walk, by least squares over the true paths of many drives.
#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <vector>

#include "robot/fit/math/least_squares.h"
#include "robot/fit/walking/drive_track.h"
#include "robot/fit/walking/drives.h"
#include "sim/motion/model.h"

namespace robot::fit {

/// The parameters that all robots share. Speeds and accelerations are fitted as logarithms.
enum WalkPart : std::size_t {
  kForward,
  kBackward,
  kSideward,
  kTurnRate,
  kTurnCost,
  kAcceleration,
  kTurnAcceleration,
  kStartDelay,
  kWalkParts
};

/// A walk with its robots. Parameters: the shared ones, then the logarithm of each robot's pace, then the error of each clock [s].
struct WalkState {
  Vector parameters;
  std::vector<std::size_t>
      clocks;  // for each robot, the one whose error of the clock is its own, too; see Drives::clocks

  std::size_t robots() const { return (parameters.size() - kWalkParts) / 2; }
  double log_pace(std::size_t robot) const { return parameters[kWalkParts + robot]; }
  double late(std::size_t robot) const { return parameters[late_index(robot)]; }
  std::size_t late_index(std::size_t robot) const { return kWalkParts + robots() + clocks[robot]; }
  /// Returns the shared parameter in its own unit.
  double value(WalkPart part) const;
  /// Returns the walk of one robot; the rest is that of `base`.
  sim::motion::Walk walk_of(std::size_t robot, const sim::motion::Walk& base) const;
};

/// How much of the drives shows a parameter.
struct Excitation {
  double amount = 0;       // [s], or starts, or changes of the gait
  std::size_t drives = 0;  // that show it
};

/// The equations of one drive around a state: linear steps of the parameters that the drive depends on.
struct DriveEquations {
  std::vector<std::size_t> which;  // parameters, by their index in the state
  std::vector<Vector> curvature;
  Vector gradient;
  double cost = 0;
  std::array<Excitation, kWalkParts> shown;
};

/// One standard deviation of the motion between two blocks, by the truth's error and the luck of the steps.
struct StepDeviation {
  double place = 1, turn = 1;  // [m], [rad]
};

/// A fitted walk.
struct WalkFit {
  WalkState state;
  sim::motion::Walk base;                              // with the luck of the steps that the fit assumed
  std::vector<std::vector<StepDeviation>> deviations;  // for each drive, for each block but the last
  std::vector<DriveEquations> equations;               // for each drive
  std::vector<bool> free;                              // for each parameter: it is fitted
  std::vector<Vector> covariance;                      // of the parameters
  Vector freedom;                                      // for each parameter: independent drives that show it, less one
  std::array<Excitation, kWalkParts> shown;

  double deviation(std::size_t parameter) const;
  /// Returns one standard deviation of a sum of parameters, each times its factor in `combination`.
  double deviation_of_sum(const Vector& combination) const;
};

/// The settings of a fit.
struct WalkProblem {
  std::vector<DriveTrack> tracks;
  Vector clock_deviation;           // [s] of each robot
  std::vector<std::size_t> clocks;  // as in Drives
  double place_deviation = 0.02, heading_deviation = 0.02;
  bool robots_differ = true;
};

WalkProblem walk_problem_of(const Drives& drives);

/// Returns how much of a parameter is enough to fit it.
double enough_of(WalkPart part);

/// Fits the walk to all drives. Parameters that the drives do not show stay those of `base`, and `free` is false.
WalkFit fit_walk(const WalkProblem& problem, const sim::motion::Walk& base);

/// Fits again from `before`, with other luck of the steps.
WalkFit refit_walk(const WalkProblem& problem, const WalkFit& before, double speed_noise, double turn_noise);

/// Adds the uncertainty of the luck of the steps to the covariance.
void add_luck(const WalkProblem& problem, double speed_noise_deviation, double turn_noise_deviation, WalkFit& fit);

/// Returns the state without some drives, by one linear step.
WalkState state_without(const WalkFit& fit, const WalkProblem& problem, const std::vector<bool>& left_out);

}  // namespace robot::fit
