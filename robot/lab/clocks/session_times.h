// Several sessions in one time base: by clock samples, or else by what ground truth and robots recorded of one game.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "robot/core/result.h"
#include "robot/lab/clocks/clock_agreement.h"
#include "robot/lab/clocks/own_path.h"
#include "robot/lab/clocks/truth_offset.h"
#include "robot/logging/sessions/session.h"

namespace robot::lab {

/// A robot's session beside ground truth.
struct JudgedRobot {
  std::size_t session = 0;  // its index
  RobotRecord record;
  Result<TruthOffset> offset;  // of its clock to that of the truth, or the reason why it is not known
};

/// Returns the robot's own path among those of the truth, or an Error if its clock or its path is not known.
Result<OwnPath> own_path(const TruthRecord& truth, const JudgedRobot& robot);

/// The times of several sessions.
struct SessionTimes {
  std::vector<Agreement> agreements;  // of each session with the first one
  TruthRecord truth;                  // of the first session that has one; empty: none
  std::vector<JudgedRobot> robots;    // all others with beliefs, if there is a truth
};

/// Compares the clocks of all sessions with that of the first. Clock samples count first. Sessions that have none in common
/// are compared by the data, if one of them has ground truth. Returns an Error with the offset if one differs by more than
/// `most_ns`; larger offsets are not searched for.
Result<SessionTimes> session_times(const std::vector<logging::Session>& sessions, std::uint64_t most_ns);

}  // namespace robot::lab
