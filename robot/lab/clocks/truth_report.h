// The report of a robot's session beside ground truth, for a person or a program.
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>

#include "robot/core/result.h"
#include "robot/lab/clocks/belief_error.h"
#include "robot/lab/clocks/session_times.h"

namespace robot::lab {

struct TruthReport {
  std::string robot;           // "14/2"
  Result<TruthOffset> offset;  // of its clock to that of the truth
  Result<BeliefErrors> ball;   // after the correction, or the reason why they are not known
};

/// Compares the robot's beliefs with the truth, after the correction of its clock.
TruthReport truth_report(const TruthRecord& truth, const JudgedRobot& robot);

/// Formats the report for a terminal, or as JSON.
std::string to_text(const TruthReport& report);
nlohmann::json to_json(const TruthReport& report);

}  // namespace robot::lab
