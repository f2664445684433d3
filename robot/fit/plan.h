// The recordings that are still missing for exact fits.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "robot/fit/evidence.h"
#include "robot/fit/kicks/kicks.h"

namespace robot::fit {

/// The state of one figure, or of one range of a curve.
struct Need {
  std::string figure;      // "ball.deceleration", "ball distance at 1.0-2.0 m"
  std::string kind;        // of the events: "free rolls"
  std::size_t events = 0;  // recorded
  double loose = 0;        // half the 95 % interval, as a share of the value; 0: not known yet
  double wanted = 0;       // the share that is enough
  std::size_t more = 0;    // events that are still missing; 0: enough
  std::string advice;      // how to record them; empty if there are enough
};

/// Returns the needs of all fits. With too few events for an interval, the number is that which recordings of RoboCup 2019
/// would have needed.
std::vector<Need> plan(const Evidence& evidence, const KickFacts& facts);

/// Formats the needs as a table for a terminal.
std::string to_text(const std::vector<Need>& needs);

}  // namespace robot::fit
