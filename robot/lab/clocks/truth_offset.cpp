#include "robot/lab/clocks/truth_offset.h"

#include <cmath>
#include <cstdint>

#include "robot/core/text.h"

namespace robot::lab {
namespace {

constexpr double kGestureReach = 1;  // [s] around the lag of a gesture

Result<TruthOffset> offset_by_motion(const TruthRecord& truth, const RobotRecord& robot, const LagRange& range) {
  const auto own = own_path(truth, robot, range);
  if (!own) return own.failure();
  const auto clock = find_offset(ball_distance(truth, own->path, robot), range);
  if (!clock) return clock.failure();
  return TruthOffset{.clock = *clock, .by = "the ball, as " + own->name + " of the truth (by " + own->by + ")"};
}

}  // namespace

ClockOffset to_clock_offset(const DataOffset& clock) {
  return {.offset_ns = std::llround(clock.offset * 1e9),
          .error_ns = static_cast<std::uint64_t>(std::llround(kTwoSided * clock.deviation * 1e9))};
}

std::string drift_text(const DataOffset& clock) {
  constexpr double kPpm = 1e6;
  if (clock.drift_deviation == 0) return "";
  return formatted("%s%.1f ppm (± %.1f ppm)", clock.drifts() ? "" : "not significant: ", clock.drift * kPpm,
                   kTwoSided * clock.drift_deviation * kPpm);
}

Result<TruthOffset> offset_from_data(const TruthRecord& truth, const RobotRecord& robot, const LagRange& range) {
  auto moved = offset_by_motion(truth, robot, range);
  if (moved) return moved;
  const auto gesture = gesture_lag(gestures_in(truth.sightings), gestures_in(robot.sightings), range);
  if (!gesture) return moved;
  moved = offset_by_motion(truth, robot, {.middle = gesture->seconds, .reach = kGestureReach});
  if (!moved)
    return TruthOffset{.clock = {.offset = gesture->seconds, .deviation = gesture->deviation},
                       .by = "the start gesture"};
  moved->by = "the start gesture and " + moved->by;
  return moved;
}

}  // namespace robot::lab
