// How old the ball is when the robot acts on it: the latency of the camera model.
#pragma once

#include "robot/fit/ball_noise/ball_places.h"
#include "robot/fit/report.h"
#include "sim/match/params.h"

namespace robot::fit {

/// Fits `camera.latency` [s], the sum of two parts. `latency.percept` is the age of a percept at the capture time of
/// its image, from balls that roll at 0.4 m/s or more. `latency.publish` is the time from capture to the writing of
/// the belief, by the times of the messages. It counts as 0, with a note, if these say nothing: in simulated games,
/// or with a writer that repeats the capture time.
///
/// `latency.belief` is the age of the believed ball at the capture time. These three are only reported.
///
/// The error of a clock adds fully to the interval: a late clock and a late percept look the same. Clocks of
/// different recordings err independently; robot and truth in one recording have no such error. A clock that was
/// compared by the motion of the ball hides the lag, so its recordings do not count.
///
/// The simulator plays latencies of 0 to 0.1 s; a value beyond is reported as `latency.total`, and the model is kept.
/// It is also kept with fewer than 8 passes of rolling balls. Without true headings only the distances of balls
/// count.
Report fit_latency(const BallPlaces& places, const sim::Models& base);
/// Reads the places and fits them.
Report fit_latency(const Evidence& evidence, const sim::Models& base);

}  // namespace robot::fit
