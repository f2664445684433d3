// The ground truth of a session: the paths of the ball and of the robots.
#pragma once

#include <cmath>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "robot/lab/clocks/series.h"
#include "robot/lab/clocks/start_gesture.h"
#include "robot/logging/sessions/session.h"

namespace robot::lab {

/// A place on the field at one moment.
struct PlaceAt {
  double at = 0;                    // [s] since the record's epoch
  double x = 0, y = 0;              // [m, field]
  double heading = NAN;             // [rad, field] of a robot; NaN where the truth has none
  std::optional<bool> fallen = {};  // of a robot; absent where the truth does not judge it
};

/// The path of one robot, or of the ball.
using Path = std::vector<PlaceAt>;  // in the order of the times

/// One robot of the ground truth.
struct TrueRobotPath {
  std::string name;  // "14/2" if it is identified, else "track 3", or "robot 1" by continuity alone
  Path path;
};

struct TruthRecord {
  std::uint64_t epoch_ns = 0;  // [ns since the epoch] of time 0
  Path ball;
  std::vector<Sighting> sightings;    // of the ball
  std::vector<TrueRobotPath> robots;  // no two with the same name
  double ball_deviation = 0.02;       // [m] of the ball's place: the median that was reported, or else a depth camera's

  bool empty() const { return sightings.empty(); }
};

/// Returns the ground truth of a session, empty without one. Leaves out damaged messages and places that are not finite.
TruthRecord read_truth(const logging::Session& session);

/// Returns the interpolated place at a moment [s] or nothing within a pause of more than SmoothCurve::kLongestGap.
/// Heading and fall are those of the nearer place.
std::optional<PlaceAt> place_at(const Path& path, double at);

/// Returns the coordinate of a path as a smooth curve.
SmoothCurve curve_of(const Path& path, double PlaceAt::*coordinate);

/// Returns the distance between two paths at the moments of the first one.
Series distances_between(const Path& one, const Path& other);

}  // namespace robot::lab
