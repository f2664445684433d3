#include "robot/lab/clocks/truth_offset.h"

#include <cmath>
#include <memory>
#include <utility>
#include <vector>

#include "robot/core/text.h"

namespace robot::lab {
namespace {

constexpr double kGestureReach = 1;  // [s] around the lag of a gesture

/// Returns one coordinate of the robot's place, as truth and robot have it.
SharedQuantity coordinate(const OwnPath& own, double PlaceAt::*of_truth, double PoseBelief::*of_robot) {
  Series believed;
  for (const PoseBelief& pose : own.poses.poses) believed.push_back({.at = pose.at, .value = pose.*of_robot});
  return {.truth = std::make_shared<SmoothCurve>(curve_of(own.path, of_truth)), .robot = tidied(std::move(believed))};
}

Result<TruthOffset> offset_by_motion(const TruthRecord& truth, const RobotRecord& robot, const LagRange& range) {
  const auto own = own_path(truth, robot, range);
  if (!own) return own.failure();
  std::vector<SharedQuantity> quantities{ball_distance(truth, own->path, robot)};
  if (!own->poses.empty()) {
    quantities.push_back(coordinate(*own, &PlaceAt::x, &PoseBelief::x));
    quantities.push_back(coordinate(*own, &PlaceAt::y, &PoseBelief::y));
  }
  const auto clock = find_offset(quantities, range);
  if (!clock) return clock.failure();
  const std::string seen = own->poses.empty() ? "the ball" : "the ball and its pose";
  return TruthOffset{.clock = *clock, .by = seen + ", as " + own->name + " of the truth (by " + own->by + ")"};
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

Result<TruthOffset> offset_from_data(const TruthRecord& truth, const RobotRecord& robot, LagRange range) {
  const auto gesture = gesture_lag(gestures_in(truth.sightings), gestures_in(robot.sightings), range);
  if (gesture) range = {.middle = gesture->seconds, .reach = kGestureReach};
  auto moved = offset_by_motion(truth, robot, range);
  if (moved && gesture) moved->by = "the start gesture and " + moved->by;
  if (moved || !gesture) return moved;
  const double middle = truth.sightings.front().at + gesture->seconds;
  return TruthOffset{
      .clock = {.offset = gesture->seconds, .deviation = gesture->deviation, .middle = middle, .drift = 0},
      .by = "the start gesture"};
}

}  // namespace robot::lab
