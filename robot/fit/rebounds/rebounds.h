// How the ball rebounds off robots and posts, and where a robot that walks into it sends it.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "robot/fit/rebounds/contacts.h"
#include "robot/fit/report.h"
#include "sim/match/params.h"

namespace robot::fit {

/// The observations of rebounds and pushes.
struct ReboundsSeen {
  std::vector<std::string> recordings;  // names of the truths, by index
  std::vector<Rebound> robots;
  PostRebounds posts;
  std::vector<Push> pushes;
  std::size_t touches = 0, unclear = 0, left_out = 0;
};

/// Finds the rebounds and pushes of all games. Restitution and sizes of `base` sort them.
ReboundsSeen read_rebounds(const Evidence& evidence, const sim::Models& base);

/// Fits the restitution to some of the rebounds: the share of the normal speed that the ball keeps. Both speeds have errors, and
/// the line between the middles deviates by `tilt` [rad]. Single bad rebounds hardly count.
double fit_restitution(const std::vector<Rebound>& rebounds, const std::vector<std::size_t>& chosen, double tilt);

/// Fits the deviation of the direction [rad] to some of the pushes, by the greatest likelihood. The errors of each turn and the
/// `tilt` [rad] of the line between the middles are subtracted. A turn that the foot bends back counts as a large one only.
double fit_push_deviation(const std::vector<Push>& pushes, const std::vector<std::size_t>& chosen, double tilt);

/// Returns the error [rad] of the line between the middles of a robot and a ball that touch: their distance scatters as much
/// along the line as across.
double tilt_of(const std::vector<double>& gaps);

/// Fits ball.robot_restitution, ball.post_restitution and contact.push_deviation to touches of the ball in the truth. Each
/// interval covers the luck of touches. Fewer than eight rebounds off robots, five off posts or twenty pushes fit nothing, nor
/// does a truth whose places are too coarse for the line between the middles.
Report fit_rebounds(const Evidence& evidence, const sim::Models& base);
Report fit_rebounds(const ReboundsSeen& seen, const sim::Models& base);

}  // namespace robot::fit
