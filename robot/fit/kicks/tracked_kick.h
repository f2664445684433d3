// One kick in the ground truth: when the foot met the ball, and how the ball left.
#pragma once

#include <cstddef>
#include <string>
#include <variant>

#include "robot/fit/kicks/kick_run.h"
#include "robot/lab/clocks/truth_record.h"

namespace robot::fit {

/// A kind of kick as the models have it, for the left foot.
struct KickKind {
  std::string name;
  double ball_x = 0, ball_y = 0;  // [m, robot] best place of the ball
  double gate_x = 0, gate_y = 0;  // [m] half size of the region in which the kick is as good as it can be
};

struct TrackedKick {
  std::size_t recording = 0;       // index of the robot's recording
  bool left = true;                // the foot
  double at = 0;                   // [s] of the touch, since the epoch of the truth
  double delay = 0;                // [s] from the begin of the kick
  double speed = 0;                // [m/s] of the ball after the touch
  double speed_deviation = 0;      // [m/s]
  double direction = 0;            // [rad, robot] of the ball, as of the left foot
  double direction_deviation = 0;  // [rad]
};

/// The reason why a kick says nothing about its kind.
enum class Untold {
  out_of_place,  // the ball was not in the gate
  disturbed,     // another robot was near, the ball moved before, or the truth has a gap
  missed,        // the ball did not move
};

/// Tracks the ball of a kick. `own` is the robot's path with headings. `deceleration` [m/s²] is that of the ball. A ball that
/// moves less than three errors of the truth did not move.
std::variant<TrackedKick, Untold> tracked(const lab::TruthRecord& truth, const lab::Path& own, const KickRun& run,
                                          const KickKind& kind, double deceleration);

}  // namespace robot::fit
