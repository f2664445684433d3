// A ball that lies still while a robot walks to it: its sizes in the pictures, and a truth by odometry.
#pragma once

#include <cstdint>
#include <functional>
#include <vector>

#include "proto/foresight/camera.pb.h"
#include "robot/core/result.h"
#include "robot/lab/import/import_sink.h"
#include "robot/lab/import/orange_ball.h"

namespace robot::lab {

/// The ball in one picture, as the camera matrix places it.
struct BallSighting {
  std::uint64_t at_ns = 0;  // [ns since the epoch]
  double x = 0, y = 0;      // [m, robot]
  double height = 0;        // [m] of the camera
};

/// The robot's way by odometry.
struct OdometryAt {
  std::uint64_t at_ns = 0;
  double x = 0, y = 0, heading = 0;  // [m, rad; frame of the odometry]
};

/// The place where a ball lay, and its errors.
struct RestingBall {
  double x = 0, y = 0;                     // [m, frame of the odometry]
  std::uint64_t begin_ns = 0, end_ns = 0;  // from the first to the last picture in which it lies there
  std::uint64_t nearest_ns = 0;            // picture that places it best
  double deviation = 0;                    // [m] one standard deviation of the place
  double way_share = 0;  // one standard deviation of a distance for each metre of way to or from `nearest_ns`
  std::size_t pictures = 0;
  double rolled = 0, direction = 0;  // [m; rad from the robot's heading] of the ball after the rest; 0: not seen again
};

/// Finds the one place that fits all sightings while the ball lies. Near ones count most: the camera's tilt is uncertain by one
/// degree. The rest ends before three sightings in a row that do not fit. Returns an Error with fewer than ten that fit, or for more than an hour.
/// `odometry` is in the order of the times.
Result<RestingBall> find_rest(const std::vector<BallSighting>& sightings, const std::vector<OdometryAt>& odometry);

/// Runs `import` with a sink that passes everything on to `sink`. For each picture of camera_bottom with its matrix it adds
/// `vision` with the orange ball. If the ball rests, it adds /truth/world, 30 times a second: the resting ball, and the robot
/// by its odometry, whose frame is that of the truth. The robot has no number. The error of their distance grows with the way to
/// the nearest picture; it is the ball's covariance. The report describes it, or says why there is no truth.
Result<ImportReport> import_with_ball(ImportSink& sink,
                                      const std::function<Result<ImportReport>(ImportSink& sink)>& import);

}  // namespace robot::lab
