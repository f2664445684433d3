// The errors of a robot's belief about the ball, against the ground truth of the same moments.
#pragma once

#include <cstddef>
#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

#include "robot/lab/clocks/data_offset.h"
#include "robot/lab/clocks/own_path.h"

namespace robot::lab {

/// The figures of many errors [m].
struct ErrorFigures {
  std::size_t samples = 0;
  double mean = 0, median = 0, p95 = 0;
};

/// Returns the figures of errors, all 0 without any.
ErrorFigures figures_of(std::vector<double> errors);

/// The errors of the images whose ball was between two distances from the robot.
struct BeliefErrorBin {
  double from = 0, to = 0;  // [m] true distance of the ball; `to` is infinite in the last bin
  ErrorFigures place;       // on the field: of the ball in the robot's frame, of its pose, and of the truth
  ErrorFigures distance;    // from the robot: its pose has no part in it
};

/// How far the ball belief was from the truth.
struct BeliefErrors {
  BeliefErrorBin all;
  std::vector<BeliefErrorBin> bins;  // by distance, without empty ones
  std::size_t too_fast = 0;  // left out: the ball moved further within the clock's error than the truth's own error
  std::size_t without_truth = 0;  // left out: the truth did not see the ball or the robot
};

/// Compares the images in which the robot saw the ball with the truth at the same time. Without poses in `own` the errors on
/// the field have no samples.
BeliefErrors belief_errors(const TruthRecord& truth, const OwnPath& own, const RobotRecord& robot,
                           const DataOffset& clock);

/// Formats the errors as a table for a terminal, or as JSON.
std::string to_text(const BeliefErrors& errors);
nlohmann::json to_json(const BeliefErrors& errors);

}  // namespace robot::lab
