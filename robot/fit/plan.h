// The recordings that are still missing for exact fits.
#pragma once

#include <string>
#include <vector>

#include "robot/fit/evidence.h"
#include "robot/fit/kicks/kicks.h"
#include "robot/fit/report.h"

namespace robot::fit {

/// Returns the needs of all fits. With too few events for an interval, the number is that which recordings of RoboCup 2019
/// would have needed.
std::vector<Need> plan(const Evidence& evidence, const KickFacts& facts);

/// Formats the needs as a table for a terminal.
std::string to_text(const std::vector<Need>& needs);

}  // namespace robot::fit
